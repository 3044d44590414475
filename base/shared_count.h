// How many share a value, kept beside the value.
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>

#if __has_include(<sys/single_threaded.h>)
#include <sys/single_threaded.h>
#endif

namespace durer {

/// Counts owners from several threads; without the cost of that as long as the program has but one.
class SharedCount {
 public:
  void add() {
    if (single_threaded()) {
      count_.store(count_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    } else {
      count_.fetch_add(1, std::memory_order_relaxed);
    }
  }
  /// True if that was the last owner.
  [[nodiscard]] bool remove() {
    if (!single_threaded()) return count_.fetch_sub(1, std::memory_order_acq_rel) == 1;
    const std::uint32_t left = count_.load(std::memory_order_relaxed) - 1;
    count_.store(left, std::memory_order_relaxed);
    return left == 0;
  }
  [[nodiscard]] bool is_single() const { return count_.load(std::memory_order_acquire) == 1; }

 private:
  [[nodiscard]] static bool single_threaded() {
#if __has_include(<sys/single_threaded.h>)
    return __libc_single_threaded != 0;
#else
    return false;
#endif
  }

  std::atomic<std::uint32_t> count_{1};
};

/// Shares an immutable value: what std::shared_ptr does, in half the size. `T` may be incomplete
/// where nothing is made, copied or destroyed.
template <typename T>
class Counted {
 public:
  Counted() = default;
  Counted(const Counted& other) noexcept : block_(other.block_) {
    if (block_ != nullptr) block_->owners.add();
  }
  Counted(Counted&& other) noexcept : block_(std::exchange(other.block_, nullptr)) {}
  Counted& operator=(Counted other) noexcept {
    std::swap(block_, other.block_);
    return *this;
  }
  ~Counted() {
    if (block_ != nullptr && block_->owners.remove()) delete block_;
  }

  template <typename... Args>
  [[nodiscard]] static Counted make(Args&&... args) {
    Counted made;
    made.block_ = new Block(std::forward<Args>(args)...);
    return made;
  }

  [[nodiscard]] explicit operator bool() const { return block_ != nullptr; }
  [[nodiscard]] const T& operator*() const { return block_->value; }
  [[nodiscard]] const T* get() const { return block_ == nullptr ? nullptr : &block_->value; }
  /// To change it; only if nobody else shares it.
  [[nodiscard]] T& own() { return block_->value; }
  [[nodiscard]] bool is_single() const { return block_ != nullptr && block_->owners.is_single(); }

  friend bool operator==(const Counted& a, const Counted& b) { return a.block_ == b.block_; }

 private:
  struct Block {
    template <typename... Args>
    explicit Block(Args&&... args) : value(std::forward<Args>(args)...) {}
    SharedCount owners;
    T value;
  };
  Block* block_ = nullptr;
};

}  // namespace durer
