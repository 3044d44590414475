// A list that is written once and then shared: copies cost nothing, however long it is.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <span>
#include <vector>

namespace durer {

/// Immutable. An empty one costs no memory, any other one allocation.
template <typename T>
class SharedList {
 public:
  SharedList() = default;
  SharedList(std::span<const T> items)  // NOLINT: meant to convert
      : size_(items.size()) {
    if (items.empty()) return;
    auto copy = std::make_shared<T[]>(items.size());  // NOLINT: an array that counts its owners
    std::copy(items.begin(), items.end(), copy.get());
    items_ = std::move(copy);
  }
  SharedList(const std::vector<T>& items)  // NOLINT: meant to convert
      : SharedList(std::span<const T>(items)) {}
  SharedList(std::initializer_list<T> items) : SharedList(std::span(items.begin(), items.size())) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const T* data() const { return items_.get(); }
  [[nodiscard]] const T* begin() const { return items_.get(); }
  [[nodiscard]] const T* end() const { return items_.get() + size_; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return items_[i]; }
  [[nodiscard]] const T& back() const { return items_[size_ - 1]; }

  /// What those lists have in common that were copied from one another.
  [[nodiscard]] const void* identity() const { return items_.get(); }

  friend bool operator==(const SharedList& a, const SharedList& b) {
    return a.items_ == b.items_ || std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  std::shared_ptr<const T[]> items_;  // NOLINT: see above
  std::size_t size_ = 0;
};

}  // namespace durer
