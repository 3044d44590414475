// A list that is written once and then shared: copies cost nothing, however long it is.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/shared_count.h"

namespace durer {

/// Immutable. An empty one costs no memory, any other one allocation.
template <typename T>
class SharedList {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 8);

 public:
  SharedList() = default;
  SharedList(std::span<const T> items) {  // NOLINT: meant to convert
    if (items.empty()) return;
    block_ = new (::operator new(sizeof(Block) + items.size_bytes())) Block;
    block_->size = items.size();
    std::uninitialized_copy(items.begin(), items.end(), reinterpret_cast<T*>(block_ + 1));
  }
  SharedList(const std::vector<T>& items)  // NOLINT: meant to convert
      : SharedList(std::span<const T>(items)) {}
  SharedList(std::initializer_list<T> items) : SharedList(std::span(items.begin(), items.size())) {}

  SharedList(const SharedList& other) noexcept : block_(other.block_) {
    if (block_ != nullptr) block_->owners.add();
  }
  SharedList(SharedList&& other) noexcept : block_(std::exchange(other.block_, nullptr)) {}
  SharedList& operator=(SharedList other) noexcept {
    std::swap(block_, other.block_);
    return *this;
  }
  ~SharedList() {
    if (block_ != nullptr && block_->owners.remove()) ::operator delete(block_);
  }

  [[nodiscard]] std::size_t size() const { return block_ == nullptr ? 0 : block_->size; }
  [[nodiscard]] bool empty() const { return block_ == nullptr; }
  [[nodiscard]] const T* data() const {
    return block_ == nullptr ? nullptr : std::launder(reinterpret_cast<const T*>(block_ + 1));
  }
  [[nodiscard]] const T* begin() const { return data(); }
  [[nodiscard]] const T* end() const { return data() + size(); }
  [[nodiscard]] const T& operator[](std::size_t i) const { return data()[i]; }
  [[nodiscard]] const T& back() const { return data()[size() - 1]; }

  /// What those lists have in common that were copied from one another.
  [[nodiscard]] const void* identity() const { return block_; }

  friend bool operator==(const SharedList& a, const SharedList& b) {
    return a.block_ == b.block_ || std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  struct Block {  // the items follow
    SharedCount owners;
    std::uint64_t size;
  };
  Block* block_ = nullptr;
};

}  // namespace durer
