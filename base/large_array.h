// Numbers by the million.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace durer {

/// Finds memory for those pages that lie within, if the system can; what they hold stays.
void prepare_memory(void* begin, std::size_t bytes);

/// As many numbers as it was made with, 0 at first. A std::vector would write these zeros, to memory
/// that the system has just cleared.
/// Not in huge pages: with these a plain picture is a tenth faster on one machine, but takes half as
/// long again on a virtual one whose host takes back what is free.
template <typename T>
class LargeArray {
  static_assert(std::is_arithmetic_v<T>);

 public:
  LargeArray() = default;
  explicit LargeArray(std::size_t size)
      : data_(static_cast<T*>(std::calloc(size, sizeof(T)))), size_(size) {
    if (!data_ && size > 0) throw std::bad_alloc();
  }
  LargeArray(const LargeArray& other) : LargeArray(other.size_) {
    std::copy(other.begin(), other.end(), begin());
  }
  LargeArray(LargeArray&& other) noexcept
      : data_(std::move(other.data_)), size_(std::exchange(other.size_, 0)) {}
  LargeArray& operator=(LargeArray other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }
  ~LargeArray() = default;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] T* data() { return data_.get(); }
  [[nodiscard]] const T* data() const { return data_.get(); }
  [[nodiscard]] T* begin() { return data(); }
  [[nodiscard]] T* end() { return data() + size_; }
  [[nodiscard]] const T* begin() const { return data(); }
  [[nodiscard]] const T* end() const { return data() + size_; }
  /// Before `count` numbers from `first` on are set for the first time: has the system find memory for
  /// all of them at once, which takes less time than page by page. They stay as they are.
  void prepare(std::size_t first, std::size_t count) {
    prepare_memory(data() + first, count * sizeof(T));
  }
  [[nodiscard]] T& operator[](std::size_t i) { return data()[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return data()[i]; }

  friend bool operator==(const LargeArray& a, const LargeArray& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  struct Free {
    void operator()(T* p) const { std::free(p); }
  };
  std::unique_ptr<T[], Free> data_;
  std::size_t size_ = 0;
};

}  // namespace durer
