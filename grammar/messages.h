// What each rule that must match is called in a diagnostic. A `must` without a line here does not
// compile.
#pragma once

#include "grammar/directives.h"

namespace durer::grammar {

template <typename Rule>
inline constexpr const char* expected = nullptr;

// clang-format off
template <> inline constexpr auto expected<rules::paren_close>     = "an operator or `)`";
template <> inline constexpr auto expected<rules::call_close>      = "an operator, `,` or `)`";
template <> inline constexpr auto expected<rules::subscript_close> = "an operator or `]`";
template <> inline constexpr auto expected<rules::condition_close> = "an operator or `)` after the condition";
template <> inline constexpr auto expected<rules::file_close>      = "an operator, `,` or `)`";
template <> inline constexpr auto expected<rules::brace_close>     = "something for this block or `}`";
template <> inline constexpr auto expected<rules::entry_close>     = "a value or `]`";

template <> inline constexpr auto expected<rules::operand>         = "an operand";
template <> inline constexpr auto expected<rules::deeper<rules::operand>> = "an operand";
template <> inline constexpr auto expected<rules::product>         = "an operand";
template <> inline constexpr auto expected<rules::additive>        = "an operand";
template <> inline constexpr auto expected<rules::relation>        = "an operand";
template <> inline constexpr auto expected<rules::bound>           = "a number";

template <> inline constexpr auto expected<rules::condition>       = "`(` and a condition";
template <> inline constexpr auto expected<rules::opening>         = "`(`";
template <> inline constexpr auto expected<rules::closing>         = "`)`";
template <> inline constexpr auto expected<rules::params_end>      = "a parameter name or `)`";
template <> inline constexpr auto expected<rules::for_open>        = "`(`";
template <> inline constexpr auto expected<rules::new_name>        = "a name that is not reserved";
template <> inline constexpr auto expected<rules::new_lvalue>      = "a name that is not reserved";
template <> inline constexpr auto expected<rules::tuple_close>     = "`,` or the end of these targets";
template <> inline constexpr auto expected<rules::lvalue>          = "a name";
template <> inline constexpr auto expected<rules::equals>          = "`=`";
template <> inline constexpr auto expected<rules::first_case>      = "`#case`, `#range` or `#else`";
template <> inline constexpr auto expected<rules::block_end>       = "`#end`";
template <> inline constexpr auto expected<rules::end_of_file>     = "an object, a directive or the end of the file";
// clang-format on

/// Failures of `must` become exceptions of our own: parse() or a directive body catches them.
template <typename Rule>
struct control : tao::pegtl::normal<Rule> {
  template <typename Input>
  [[noreturn]] static void raise(const Input& in, Builder& b) {
    static_assert(expected<Rule> != nullptr, "a rule that must match needs a line in messages.h");
    throw b.failure(in.current(), expected<Rule>);
  }
};

}  // namespace durer::grammar
