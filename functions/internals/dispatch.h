// From a number to the formula, for one kind of number.
#pragma once

#include "functions/internals.h"
#include "functions/internals/algebraic.h"
#include "functions/internals/blobs.h"
#include "functions/internals/fractals.h"
#include "functions/internals/profiles.h"
#include "functions/internals/shapes.h"

namespace durer::functions {

template <class T>
using InternalKernel = T (*)(const Args<T>&);

template <class T>
inline constexpr std::array<InternalKernel<T>, internal_functions.size()> internal_kernels{
#define DURER_INTERNAL(name, extra, parameters) internals::name<T>,
#include "functions/internals.def"
#undef DURER_INTERNAL
};

template <class T>
[[nodiscard]] T dispatch_internal(int number, const T* a, const Context& context) {
  return internal_kernels<T>[static_cast<std::size_t>(number)]({a[0], a[1], a[2], a + 3, context});
}

}  // namespace durer::functions
