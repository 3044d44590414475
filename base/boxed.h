// A value of which many copies are alike: they share one until somebody changes his.
#pragma once

#include <utility>

#include "base/shared_count.h"

namespace durer {

/// Copying shares; `edit` makes sure that nobody else sees the change. A default-made one costs no
/// memory. Reading from several threads is fine, editing is for one.
template <typename T>
class Boxed {
 public:
  Boxed() = default;
  Boxed(T value)  // NOLINT: meant to convert
      : value_(Counted<T>::make(std::move(value))) {}

  [[nodiscard]] const T& get() const {
    static const T plain{};
    return value_ ? *value_ : plain;
  }
  const T& operator*() const { return get(); }
  const T* operator->() const { return &get(); }

  T& edit() {
    if (!value_.is_single()) value_ = Counted<T>::make(get());
    return value_.own();
  }
  /// True if both are the same one, and not merely equal.
  [[nodiscard]] bool same(const Boxed& other) const { return value_ == other.value_; }
  [[nodiscard]] const void* identity() const { return value_.get(); }
  [[nodiscard]] bool is_plain() const { return !value_; }

 private:
  Counted<T> value_;
};

}  // namespace durer
