#pragma once

// A function or lambda that becomes part of its caller, and so is compiled for the caller's
// instruction set.
#define DURER_INLINE inline __attribute__((always_inline))
#define DURER_LAMBDA_INLINE __attribute__((always_inline))
