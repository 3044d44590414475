// A list that grows without moving what it holds.
#pragma once

#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace durer {

/// Like std::vector, for millions of large values: growing neither copies nor needs twice the
/// memory for a while, and references stay valid. `Bits`: a chunk holds 2^Bits values.
template <typename T, unsigned Bits = 8>
class Chunked {
 public:
  static constexpr std::size_t chunk = std::size_t{1} << Bits;

  Chunked() = default;
  explicit Chunked(std::size_t size) { resize(size); }
  Chunked(Chunked&&) noexcept = default;
  Chunked& operator=(Chunked&&) noexcept = default;
  Chunked(const Chunked& other) { append(other); }
  Chunked& operator=(const Chunked& other) {
    if (this == &other) return *this;
    clear();
    append(other);
    return *this;
  }
  ~Chunked() = default;

  [[nodiscard]] std::size_t size() const {
    return chunks_.empty() ? 0 : (chunks_.size() - 1) * chunk + chunks_.back().size();
  }
  [[nodiscard]] bool empty() const { return chunks_.empty(); }
  T& operator[](std::size_t i) { return chunks_[i >> Bits][i & (chunk - 1)]; }
  const T& operator[](std::size_t i) const { return chunks_[i >> Bits][i & (chunk - 1)]; }
  [[nodiscard]] T& back() { return chunks_.back().back(); }
  [[nodiscard]] const T& back() const { return chunks_.back().back(); }

  void push_back(T value) { emplace_back(std::move(value)); }
  template <typename... Args>
  T& emplace_back(Args&&... args) {
    if (chunks_.empty() || chunks_.back().size() == chunk) {
      chunks_.emplace_back();
      chunks_.back().reserve(chunk);
    }
    return chunks_.back().emplace_back(std::forward<Args>(args)...);
  }
  void pop_back() {
    chunks_.back().pop_back();
    if (chunks_.back().empty()) chunks_.pop_back();
  }
  void clear() { chunks_.clear(); }
  void resize(std::size_t size) {
    while (this->size() < size) emplace_back();
    while (this->size() > size) pop_back();
  }

  template <typename List, typename Value>
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = Value*;
    using reference = Value&;

    Iterator() = default;
    Iterator(List& list, std::size_t at) : list_(&list), at_(at) {}
    Value& operator*() const { return (*list_)[at_]; }
    Value* operator->() const { return &(*list_)[at_]; }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    Iterator operator++(int) {
      Iterator before = *this;
      ++at_;
      return before;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_; }

   private:
    List* list_ = nullptr;
    std::size_t at_ = 0;
  };
  [[nodiscard]] auto begin() { return Iterator<Chunked, T>(*this, 0); }
  [[nodiscard]] auto end() { return Iterator<Chunked, T>(*this, size()); }
  [[nodiscard]] auto begin() const { return Iterator<const Chunked, const T>(*this, 0); }
  [[nodiscard]] auto end() const { return Iterator<const Chunked, const T>(*this, size()); }

 private:
  void append(const Chunked& other) {
    for (const T& value : other) push_back(value);
  }

  std::vector<std::vector<T>> chunks_;
};

}  // namespace durer
