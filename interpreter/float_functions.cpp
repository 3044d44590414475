#include "interpreter/float_functions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "interpreter/arguments.h"

namespace durer::interpreter {
namespace {

namespace w = grammar::words;

using Args = const double*;

constexpr std::uint8_t any = 8;  // arguments of `max` and `min` in formulas

double select(Args a, std::size_t count) {
  return a[a[0] < 0 ? 1 : a[0] == 0 || count == 3 ? 2 : 3];
}

double to_degrees(double x) { return x / radians_per_degree; }
double to_radians(double x) { return x * radians_per_degree; }
double to_whole(double x) { return to_int(x); }

/// A function of one float that has a value everywhere.
template <double (*F)(double)>
bool plain(Args a, std::size_t, double& out) {
  out = F(a[0]);
  return true;
}

constexpr std::array functions{
    FloatFunction{w::abs, 1, 1, plain<std::abs>},
    FloatFunction{w::acos, 1, 1,
                  [](Args a, std::size_t, double& out) {
                    out = std::acos(a[0]);
                    return !(a[0] < -1 || a[0] > 1);
                  }},
    FloatFunction{w::acosh, 1, 1, plain<std::acosh>},
    FloatFunction{w::asin, 1, 1,
                  [](Args a, std::size_t, double& out) {
                    out = std::asin(a[0]);
                    return !(a[0] < -1 || a[0] > 1);
                  }},
    FloatFunction{w::asinh, 1, 1, plain<std::asinh>},
    FloatFunction{w::atan, 1, 1, plain<std::atan>},
    FloatFunction{w::atanh, 1, 1, plain<std::atanh>},
    FloatFunction{w::ceil, 1, 1, plain<std::ceil>},
    FloatFunction{w::cos, 1, 1, plain<std::cos>},
    FloatFunction{w::cosh, 1, 1, plain<std::cosh>},
    FloatFunction{w::degrees, 1, 1, plain<to_degrees>},
    FloatFunction{w::exp, 1, 1, plain<std::exp>},
    FloatFunction{w::floor, 1, 1, plain<std::floor>},
    FloatFunction{w::int_, 1, 1, plain<to_whole>},
    FloatFunction{w::ln, 1, 1,
                  [](Args a, std::size_t, double& out) {
                    out = std::log(a[0]);
                    return !(a[0] <= 0);
                  }},
    FloatFunction{w::log, 1, 1,
                  [](Args a, std::size_t, double& out) {
                    out = std::log10(a[0]);
                    return !(a[0] <= 0);
                  }},
    FloatFunction{w::radians, 1, 1, plain<to_radians>},
    FloatFunction{w::sin, 1, 1, plain<std::sin>},
    FloatFunction{w::sinh, 1, 1, plain<std::sinh>},
    FloatFunction{w::sqrt, 1, 1,
                  [](Args a, std::size_t, double& out) {
                    out = std::sqrt(a[0]);
                    return !(a[0] < 0);
                  }},
    FloatFunction{w::tan, 1, 1, plain<std::tan>},
    FloatFunction{w::tanh, 1, 1, plain<std::tanh>},
    FloatFunction{w::atan2, 2, 2,
                  [](Args a, std::size_t, double& out) {
                    out = std::atan2(a[0], a[1]);
                    return std::abs(a[0]) > epsilon || std::abs(a[1]) > epsilon;
                  }},
    FloatFunction{w::div, 2, 2,
                  [](Args a, std::size_t, double& out) {
                    out = to_int(a[0] / a[1]);
                    return true;
                  }},
    FloatFunction{w::mod, 2, 2,
                  [](Args a, std::size_t, double& out) {
                    out = modulo(a[0], a[1]);
                    return true;
                  }},
    FloatFunction{w::pow, 2, 2,
                  [](Args a, std::size_t, double& out) {
                    out = std::pow(a[0], a[1]);
                    return a[0] != 0 || a[1] != 0;
                  }},
    FloatFunction{w::max, 1, any,
                  [](Args a, std::size_t count, double& out) {
                    out = a[0];
                    for (std::size_t i = 1; i < count; ++i) out = std::max(out, a[i]);
                    return true;
                  }},
    FloatFunction{w::min, 1, any,
                  [](Args a, std::size_t count, double& out) {
                    out = a[0];
                    for (std::size_t i = 1; i < count; ++i) out = std::min(out, a[i]);
                    return true;
                  }},
    FloatFunction{w::select, 3, 4,
                  [](Args a, std::size_t count, double& out) {
                    out = select(a, count);
                    return true;
                  }}};

}  // namespace

const FloatFunction* float_function(grammar::SymbolId word) {
  const auto* found = std::ranges::find(functions, word, &FloatFunction::word);
  return found == functions.end() ? nullptr : found;
}

}  // namespace durer::interpreter
