// PEGTL's own check of a grammar: no rule can loop without consuming anything.
#include <tao/pegtl/contrib/analyze.hpp>

#include "grammar/actions.h"
#include "grammar/scan.h"
#include "tests/support/catch.h"

namespace rules = durer::grammar::rules;

namespace tao::pegtl {
template <typename Name, typename Self>
struct analyze_traits<Name, rules::predicate<Self>> : analyze_opt_traits<> {};
template <typename Name, auto... Ids>
struct analyze_traits<Name, rules::predicate<rules::one_word<Ids...>>> : analyze_any_traits<> {};
template <typename Name, auto Class>
struct analyze_traits<Name, rules::predicate<rules::word_of<Class>>> : analyze_any_traits<> {};
template <typename Name, char C>
struct analyze_traits<Name, rules::predicate<rules::paired<C>>> : analyze_any_traits<> {};
template <typename Name>
struct analyze_traits<Name, rules::predicate<rules::any_word>> : analyze_any_traits<> {};
template <typename Name>
struct analyze_traits<Name, rules::predicate<rules::operand_word>> : analyze_any_traits<> {};
template <typename Name>
struct analyze_traits<Name, rules::predicate<rules::stray_bracket>> : analyze_any_traits<> {};
template <typename Name>
struct analyze_traits<Name, rules::predicate<rules::scan_literals>> : analyze_any_traits<> {};
template <typename Name>
struct analyze_traits<Name, rules::predicate<rules::literals_item>> : analyze_any_traits<> {};
template <typename Name>
struct analyze_traits<Name, rules::block_comment> : analyze_any_traits<> {};
template <typename Name, typename Rule>
struct analyze_traits<Name, rules::deeper<Rule>> : analyze_seq_traits<Rule> {};
template <typename Name, typename Rule>
struct analyze_traits<Name, rules::attempt<Rule>> : analyze_seq_traits<Rule> {};
template <typename Name, typename Rule>
struct analyze_traits<Name, rules::recover<Rule>> : analyze_sor_traits<Rule, rules::fallback> {};
template <typename Name>
struct analyze_traits<Name, rules::vector> : analyze_seq_traits<rules::vector_text> {};
}  // namespace tao::pegtl

TEST_CASE("grammar: no rule can loop without progress", "[grammar][analyze]") {
  CHECK(tao::pegtl::analyze<rules::file>(1) == 0);
  CHECK(tao::pegtl::analyze<rules::scan>(1) == 0);
}
