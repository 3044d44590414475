// A value of which many copies are alike: they share one until somebody changes his.
#pragma once

#include <memory>
#include <utility>

namespace durer {

/// Copying shares; `edit` makes sure that nobody else sees the change. A default-made one costs no
/// memory. Reading from several threads is fine, editing is for one.
template <typename T>
class Boxed {
 public:
  Boxed() = default;
  Boxed(T value)  // NOLINT: meant to convert
      : value_(std::make_shared<T>(std::move(value))) {}
  /// Takes part in sharing `value`, which must not be changed by others any more.
  explicit Boxed(std::shared_ptr<const T> value) : value_(std::move(value)) {}

  [[nodiscard]] const T& get() const {
    static const T plain{};
    return value_ ? *value_ : plain;
  }
  const T& operator*() const { return get(); }
  const T* operator->() const { return &get(); }

  T& edit() {
    if (!value_ || value_.use_count() > 1) value_ = std::make_shared<const T>(get());
    return const_cast<T&>(*value_);  // ours alone
  }
  /// True if both are the same one, and not merely equal.
  [[nodiscard]] bool same(const Boxed& other) const { return value_ == other.value_; }
  [[nodiscard]] const void* identity() const { return value_.get(); }
  [[nodiscard]] bool is_plain() const { return value_ == nullptr; }

 private:
  std::shared_ptr<const T> value_;
};

}  // namespace durer
