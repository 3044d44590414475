// Items: what a file, a block, an argument list or a directive body is made of (language §7.2).
// No rule here knows a block by name, but for one: the body of `function` is a full expression.
#pragma once

#include "grammar/expressions.h"

namespace durer::grammar::rules {

struct directive;
struct directive_ahead;
struct fallback;

/// One item. In a directive body nothing is an error until it is executed: what cannot be read
/// becomes its single tokens there, and the tree remembers why (ast::Flaw). Outside of them it ends
/// the parse; a second, lenient one only looks for more errors and skips bad items as a whole.
template <typename Rule>
struct recover {
  using rule_t = recover;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <typename...> class Action,
            template <typename...> class Control, typename Input>
  static bool match(Input& in, Builder& b) {
    const char* const at = in.current();
    b.start_item(at);
    if (!b.in_body()) {
      if (b.skips_bad_items()) return match_or_skip<A, Action, Control>(in, b);
      return Control<Rule>::template match<A, M, Action, Control>(in, b);
    }
    if (!b.known_bad_item(at)) {
      const auto checkpoint = b.checkpoint();
      try {
        return Control<Rule>::template match<A, p::rewind_mode::required, Action, Control>(in, b);
      } catch (const Failure& why) {
        if (why.final()) throw;
        in.iterator() = at;
        b.rollback(checkpoint);
        b.remember_bad_item(at);
        b.flaw(at, why);
      }
    }
    return Control<fallback>::template match<A, M, Action, Control>(in, b);
  }

  template <p::apply_mode A, template <typename...> class Action,
            template <typename...> class Control, typename Input>
  static bool match_or_skip(Input& in, Builder& b) {
    const char* const at = in.current();
    const auto checkpoint = b.checkpoint();
    try {
      return Control<Rule>::template match<A, p::rewind_mode::required, Action, Control>(in, b);
    } catch (const Failure& why) {
      if (why.final()) throw;
      in.iterator() = at;
      b.rollback(checkpoint);
      const char* const next = b.skip_bad_item(at, why);
      if (next == nullptr) throw;
      in.bump(static_cast<std::size_t>(next - at));
      return Control<gap>::template match<A, p::rewind_mode::dontcare, Action, Control>(in, b);
    }
  }
};

// clang-format off

template <typename Expression>
struct expression_item  : p::seq<Expression> {};
struct word_item        : keyword {};

// ---- groups --------------------------------------------------------------------------------------

struct brace_close      : paired<'}'> {};
struct block_open       : paired<'{'> {};
struct block            : p::seq<block_open, gap, deeper<items<plain_mode>>, p::must<brace_close>, gap> {};

struct function_ahead   : predicate<function_ahead> {
  template <typename Input>
  static bool test(Input&, Builder& b) { return b.function_ahead(); }
};
struct function_open    : paired<'{'> {};
struct function_body    : p::seq<p::at<paired<'{'>>, function_ahead, function_open, gap,
                                 deeper<items<full_mode>>, p::must<brace_close>, gap> {};

struct entry_open       : paired<'['> {};
struct entry_close      : paired<']'> {};
struct entry            : p::seq<entry_open, gap, deeper<items<plain_mode>>, p::must<entry_close>, gap> {};

// ---- marks ---------------------------------------------------------------------------------------

/// A bracket without partner.
struct stray_bracket    : predicate<stray_bracket> {
  template <typename Input>
  static bool test(Input& in, Builder& b) {
    if (!b.is_stray(in.current())) return false;
    in.bump(1);
    return true;
  }
};
struct two_marks        : p::sor<p::string<'<', '='>, p::string<'>', '='>, p::string<'!', '='>> {};
struct one_mark         : p::one<',', ';', '+', '-', '*', '/', '=', '&', '|', '!', '?', ':', '.', '<', '>',
                                 '^', '@', '$', '%', '~', '`', '\'', '\\'> {};
struct terminator;
struct hash_mark        : p::seq<p::not_at<terminator>, p::one<'#'>> {};
struct any_mark         : p::sor<two_marks, one_mark, stray_bracket, hash_mark> {};
struct mark             : any_mark {};

struct mark_allowed     : predicate<mark_allowed> {
  template <typename Input>
  static bool test(Input& in, Builder& b) { return !in.empty() && b.mark_allowed(in.current()); }
};
struct not_in_vector    : predicate<not_in_vector> {
  template <typename Input>
  static bool test(Input&, Builder& b) { return !b.in_vector(); }
};
/// An operator whose operand a directive, or the file that includes this one, may supply.
struct mark_explained   : p::seq<not_in_vector, p::at<one_mark, gap, p::sor<directive_ahead, p::eof>>> {};
struct mark_item        : p::seq<p::sor<mark_allowed, mark_explained>, mark> {};

struct comma_mark       : p::one<','> {};
struct comma_item       : p::seq<comma_mark> {};

// ---- items in their places -----------------------------------------------------------------------

/// A list of literals too long to be read one by one.
struct literals_item    : predicate<literals_item> {
  template <typename Input>
  static bool test(Input& in, Builder& b) {
    if (in.empty() || !may_begin_literal(in.peek_char())) return false;
    const std::size_t size = b.literals_item(in.current());
    in.bump(size);
    return size > 0;
  }
};

template <typename Expression>
struct item_of          : recover<p::sor<p::seq<comma_item, gap>,
                                         p::seq<literals_item, gap>,
                                         directive,
                                         function_body, block, entry,
                                         expression_item<Expression>,
                                         p::seq<p::sor<word_item, mark_item>, gap>>> {};
template <>
struct items<plain_mode>    : p::star<item_of<additive>> {};
template <>
struct items<full_mode>     : p::star<item_of<full>> {};
template <>
struct items<argument_mode> : p::star<recover<p::sor<p::seq<comma_item, gap>,
                                                     directive,
                                                     function_body, block, entry,
                                                     expression_item<argument>,
                                                     resumed_argument,
                                                     p::seq<p::sor<word_item, mark_item>, gap>>>> {};
struct component        : p::sor<p::seq<comma_item, gap>,
                                 directive,
                                 expression_item<additive>,
                                 p::seq<mark_item, gap>> {};
template <>
struct items<vector_mode>   : p::star<component> {};

// clang-format on

}  // namespace durer::grammar::rules
