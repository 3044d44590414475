#include "functions/names.h"

#include <algorithm>
#include <array>
#include <utility>

namespace durer::functions {
namespace {

// clang-format off
constexpr std::array table{
    BuiltIn{"abs",   Op::absolute,               1}, BuiltIn{"acos",  Op::arccosine,              1},
    BuiltIn{"acosh", Op::hyperbolic_arccosine,   1}, BuiltIn{"asin",  Op::arcsine,                1},
    BuiltIn{"asinh", Op::hyperbolic_arcsine,     1}, BuiltIn{"atan",  Op::arctangent,             1},
    BuiltIn{"atan2", Op::arctangent2,            2}, BuiltIn{"atanh", Op::hyperbolic_arctangent,  1},
    BuiltIn{"ceil",  Op::ceiling,                1}, BuiltIn{"cos",   Op::cosine,                 1},
    BuiltIn{"cosh",  Op::hyperbolic_cosine,      1}, BuiltIn{"div",   Op::quotient,               2},
    BuiltIn{"exp",   Op::exponential,            1}, BuiltIn{"floor", Op::floor,                  1},
    BuiltIn{"int",   Op::truncate,               1}, BuiltIn{"ln",    Op::ln,                     1},
    BuiltIn{"log",   Op::log10,                  1}, BuiltIn{"max",   Op::maximum,                2, true},
    BuiltIn{"min",   Op::minimum,                2, true}, BuiltIn{"mod", Op::modulo,             2},
    BuiltIn{"pow",   Op::power,                  2}, BuiltIn{"sin",   Op::sine,                   1},
    BuiltIn{"sinh",  Op::hyperbolic_sine,        1}, BuiltIn{"sqrt",  Op::square_root,            1},
    BuiltIn{"tan",   Op::tangent,                1}, BuiltIn{"tanh",  Op::hyperbolic_tangent,     1},
};
constexpr std::array<std::pair<std::string_view, Member>, 14> members{{
    {"x", Member::x},         {"y", Member::y},               {"z", Member::z},
    {"t", Member::t},         {"u", Member::u},               {"v", Member::v},
    {"red", Member::red},     {"green", Member::green},       {"blue", Member::blue},
    {"filter", Member::filter}, {"transmit", Member::transmit},
    {"gray", Member::gray},   {"grey", Member::gray},         {"hf", Member::hf},
}};
// clang-format on
static_assert(std::ranges::is_sorted(table, {}, &BuiltIn::name));

}  // namespace

std::span<const BuiltIn> built_ins() { return table; }

const BuiltIn* built_in(std::string_view name) {
  const auto* found = std::ranges::lower_bound(table, name, {}, &BuiltIn::name);
  return found != table.end() && found->name == name ? found : nullptr;
}

std::optional<Member> member_named(std::string_view name) {
  for (const auto& [text, member] : members) {
    if (text == name) return member;
  }
  return std::nullopt;
}

}  // namespace durer::functions
