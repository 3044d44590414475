// The functions of the language (language §3). Arguments are read one by one, in textual order,
// because `rand` and macro calls have effects.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <fmt/printf.h>
#include <glm/geometric.hpp>

#include "functions/noise.h"
#include "interpreter/arguments.h"
#include "interpreter/float_functions.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

/// `v` turned about the unit vector `k` by `angle` radians: Rodrigues' matrix, with products and
/// sums in the order that gives the oracle's last bits.
dvec3 rotate_about(dvec3 v, dvec3 k, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const dvec3 x(k.x * k.x + c * (1 - k.x * k.x), k.x * k.y * (1 - c) + k.z * s,
                k.x * k.z * (1 - c) - k.y * s);
  const dvec3 y(k.x * k.y * (1 - c) - k.z * s, k.y * k.y + c * (1 - k.y * k.y),
                k.y * k.z * (1 - c) + k.x * s);
  const dvec3 z(k.x * k.z * (1 - c) + k.y * s, k.y * k.z * (1 - c) - k.x * s,
                k.z * k.z + c * (1 - k.z * k.z));
  return v.x * x + v.y * y + v.z * z + dvec3(0.0);
}
/// Where a function of floats has none.
std::string_view why_without_value(SymbolId function) {
  switch (function) {
    case w::ln:
    case w::log: return "needs an argument above 0";
    case w::sqrt: return "of a negative number has no value";
    default: return "of (0, 0) has no value";
  }
}

}  // namespace

double Interpreter::days_since_2000() {
  using namespace std::chrono;
  const auto micro = duration_cast<microseconds>(system_clock::now().time_since_epoch()).count();
  constexpr double epoch_2000 = 10957;  // days from 1970 to 2000
  return static_cast<double>(micro) / 86400e6 - epoch_2000;
}

Num Interpreter::call_builtin(const ast::Tree& tree, const ast::Expr& e, SymbolId function,
                              std::span<const ast::ExprId> list, const ast::OpenGroup* open,
                              int length) {
  Args args(*this, tree, e, function, list, open);
  const auto number = [&](double x) {
    args.done();
    return Num::filled(x, length);
  };
  const auto vector = [&](dvec3 v) {
    args.done();
    return Num(v);
  };
  const auto domain = [&](std::string_view what) {
    fail(Code::evaluation, e.span, fmt::format("`{}` {}", name_of(function), what));
  };
  // What the table has with a fixed number of arguments; the others take more here than there.
  const FloatFunction* f = float_function(function);
  if (f != nullptr && f->least == f->most) {
    std::array<double, 2> x{};
    if (f->least == 1) {
      x[0] = args.full();
    } else {
      for (double& a : x) a = args.number();
    }
    double result = 0;
    if (f->apply(x.data(), f->least, result)) return number(result);
    if (function != w::acos && function != w::asin) domain(why_without_value(function));
    warn(Code::evaluation, e.span,
         fmt::format("the argument of `{}` is outside -1…1 and is clamped", name_of(function)));
    x[0] = x[0] < 0 ? -1 : 1;
    f->apply(x.data(), 1, result);
    return number(result);
  }
  switch (function) {
    case w::max:
    case w::min: {
      double x = args.number();
      while (args.more()) {
        const double y = args.number();
        x = function == w::max ? std::max(x, y) : std::min(x, y);
      }
      return number(x);
    }
    case w::bitwise_and:
    case w::bitwise_or:
    case w::bitwise_xor: {
      std::int32_t x = args.integer();
      while (args.more()) {
        const std::int32_t y = args.integer();
        x = function == w::bitwise_and ? x & y : function == w::bitwise_or ? x | y : x ^ y;
      }
      return number(x);
    }
    case w::select: {
      const double c = args.number();
      const Num below = (length == 1 ? args.any() : args.num(length));
      const Num zero = (length == 1 ? args.any() : args.num(length));
      const Num above = args.more() ? (length == 1 ? args.any() : args.num(length)) : zero;
      args.done();
      return c < 0 ? below : (c == 0 ? zero : above);
    }
    case w::asc: {
      const Text t = args.text();
      return number(t.empty() ? 0 : t[0]);
    }
    case w::strlen: return number(static_cast<double>(args.text().size()));
    case w::val: return number(args.text().leading_number());
    case w::strcmp: {
      const Text a = args.text();
      return number(a.difference(args.text()));
    }
    case w::file_exists: return number(find_file(args.text().bytes(), e.span, {}, false) ? 1 : 0);
    case w::defined: {
      if (args.skip_word()) return number(0);  // words of the language are not declared
      const ast::ExprId id = args.expression();
      return number(is_defined(tree, id) ? 1 : 0);
    }
    case w::dimensions:
    case w::dimension_size: {
      const ast::ExprId id = args.expression();
      const Value* v = lookup(tree, id, true);
      const auto* array = v == nullptr ? nullptr : v->get<std::shared_ptr<Array>>();
      if (array == nullptr) {
        fail(Code::wrong_kind, tree.exprs[id].span,
             fmt::format("`{}` wants an array here", name_of(function)));
      }
      const auto& sizes = (*array)->sizes;
      if (function == w::dimensions) return number(static_cast<double>(sizes.size()));
      const int d = args.integer();
      return number(d < 1 || d > static_cast<int>(sizes.size())
                        ? 0
                        : static_cast<double>(sizes[static_cast<std::size_t>(d) - 1]));
    }
    case w::seed: {
      streams_.push_back(static_cast<std::uint32_t>(args.integer()));
      return number(static_cast<double>(streams_.size() - 1));
    }
    case w::rand: {
      const std::int32_t i = args.integer();
      if (i < 0 || static_cast<std::size_t>(i) >= streams_.size()) {
        fail(Code::out_of_range, e.span, "there is no such random stream",
             "make one first: `#declare S = seed(1);`, then `rand(S)`");
      }
      std::uint32_t& s = streams_[static_cast<std::size_t>(i)];
      if (peek_ != nullptr) peek_->push_back({static_cast<std::size_t>(i), s});
      return number(draw(s));
    }
    case w::vdot: {
      const dvec3 a = args.vector();
      return number(glm::dot(a, args.vector()));
    }
    case w::vlength: return number(glm::length(args.vector()));
    case w::vcross: {
      const dvec3 a = args.vector();
      return vector(glm::cross(a, args.vector()));
    }
    case w::vnormalize: {
      const dvec3 a = args.vector();
      const double n = glm::length(a);
      if (n == 0) {
        if (version() >= 350) warn(Code::evaluation, e.span, "`vnormalize` of a zero vector");
        return vector(dvec3(0));
      }
      return vector(a * (1 / n));  // as the oracle rounds
    }
    case w::vrotate: {
      const dvec3 a = args.vector();
      return vector(Transform::rotate_deg(args.vector()).point(a));  // no -0
    }
    case w::vaxis_rotate: {
      const dvec3 v = args.vector();
      const dvec3 axis = args.vector();
      const double angle = args.number() * radians_per_degree;
      return vector(rotate_about(v, axis * (1 / glm::length(axis)), angle));
    }
    case w::trace: {
      const scene::ObjectId id = object_argument(tree, args.expression(), e.span);
      const dvec3 from = args.vector();
      const dvec3 along = args.vector();
      const auto hit = options_.queries->trace(scene_, id, from, along);
      if (args.more()) {
        const ast::ExprId target = args.expression();
        Value* v = lookup(tree, target, true);
        const Num* n = v == nullptr ? nullptr : v->get<Num>();
        if (n == nullptr || n->length != 3) {
          fail(Code::wrong_kind, tree.exprs[target].span, "expected a variable that holds a vector",
               "declare it first: `#declare Norm = <0,0,0>;`");
        }
        *v = Value(Num(hit ? hit->normal : dvec3(0.0)));
      }
      return vector(hit ? hit->point : dvec3(0.0));
    }
    case w::inside: {
      const ast::ExprId object = args.expression();
      const scene::ObjectId id = object_argument(tree, object, e.span);
      const auto in = options_.queries->inside(scene_, id, args.vector());
      if (!in)
        fail(Code::wrong_kind, tree.exprs[object].span,
             "this object is a surface without an inside");
      return number(*in ? 1 : 0);
    }
    case w::min_extent:
    case w::max_extent: {
      const scene::ObjectId id = object_argument(tree, args.expression(), e.span);
      const Bounds3 box = options_.queries->extent(scene_, id);
      return vector(function == w::min_extent ? box.lo : box.hi);
    }
    case w::vturbulence: {
      functions::Octaves octaves;
      octaves.lambda = static_cast<float>(args.number());
      octaves.omega = static_cast<float>(args.number());
      octaves.count = std::clamp(args.integer(), 1, 10);
      return vector(functions::vturbulence(args.vector(), octaves));
    }
    case w::sum:
    case w::prod:
      fail(Code::unexpected_item, e.span,
           fmt::format("`{}` exists only inside of functions", name_of(function)));
    default:
      fail(Code::wrong_kind, e.span,
           fmt::format("expected a number or vector, found the string function `{}`",
                       name_of(function)));
  }
}

/// The declared object that an argument names.
scene::ObjectId Interpreter::object_argument(const ast::Tree& tree, ast::ExprId id, Span call) {
  const Value* v = lookup(tree, id, true);
  const auto* ref = v == nullptr ? nullptr : v->get<ObjectRef>();
  if (ref == nullptr) {
    fail(Code::wrong_kind, tree.exprs[id].span,
         v == nullptr ? std::string("expected the name of a declared object")
                      : fmt::format("expected an object, found {}", kind_name(*v)));
  }
  if (options_.queries == nullptr) not_supported("asking an object without a tracer", call);
  if (const auto feature = options_.queries->unsupported(scene_, ref->id))
    not_supported(*feature, call);
  return ref->id;
}

}  // namespace durer::interpreter
