// Tokens: white space, comments, numbers, strings, words (language §1). Shared by the scan that
// pairs brackets and directives (balance.h) and by the grammar proper.
#pragma once

#include <tao/pegtl.hpp>

#include "grammar/builder.h"

namespace durer::grammar::rules {

namespace p = tao::pegtl;

/// A rule that is a function of input and state: Self::test(in, state) consumes on success only.
template <typename Self>
struct predicate {
  using rule_t = predicate;
  using subs_t = p::type_list<>;
  template <p::apply_mode A, p::rewind_mode M, template <typename...> class Action,
            template <typename...> class Control, typename Input, typename State>
  static bool match(Input& in, State& state) {
    return Self::test(in, state);
  }
};

// ---- what separates tokens
// -----------------------------------------------------------------------

// NUL and Control-Z count as white space (language §1.1).
struct blank : p::ranges<'\t', '\r', ' ', ' ', '\x1A', '\x1A', '\0'> {};
struct line_comment : p::seq<p::two<'/'>, p::star<p::not_one<'\n', '\r'>>> {};

// Comments nest. Counting instead of recursion: a file may hold a million `/*`.
struct block_comment {
  using rule_t = block_comment;
  using subs_t = p::type_list<>;
  template <typename Input>
  static bool match(Input& in) {
    if (in.size(2) < 2 || in.peek_char() != '/' || in.peek_char(1) != '*') return false;
    const char* const end = in.end();
    int depth = 1;
    for (const char* c = in.current() + 2; end - c >= 2; ++c) {
      if (c[0] == '*' && c[1] == '/') {
        ++c;
        if (--depth > 0) continue;
        in.bump(static_cast<std::size_t>(c + 1 - in.current()));
        return true;
      }
      if (c[0] == '/' && c[1] == '*') {
        ++c;
        ++depth;
      }
    }
    return false;
  }
};

// clang-format off
struct gap              : p::star<p::sor<blank, line_comment, block_comment>> {};

// ---- literals ------------------------------------------------------------------------------------

// `1.` and `.5` are numbers, and so is `1e`, which means 1 (language §1.3).
struct digits           : p::plus<p::digit> {};
struct exponent         : p::seq<p::one<'e', 'E'>, p::opt<p::sor<p::one<'+', '-'>, p::digit>>, p::star<p::digit>> {};
struct whole_number     : p::seq<digits, p::opt<p::one<'.'>, p::star<p::digit>>, p::opt<exponent>> {};
struct fraction         : p::seq<p::one<'.'>, digits, p::opt<exponent>> {};
struct number           : p::sor<whole_number, fraction> {};

struct string_char      : p::sor<p::not_one<'"', '\\'>, p::seq<p::one<'\\'>, p::not_one<'\n', '\r'>>> {};
struct string           : p::seq<p::one<'"'>, p::star<string_char>, p::one<'"'>> {};

// ---- words ---------------------------------------------------------------------------------------

struct word_text        : p::identifier {};
// clang-format on

/// A word that `Self::accepts` by its class or its id.
template <typename Self>
struct word_rule : predicate<Self> {
  template <typename Input>
  static bool test(Input& in, Builder& b) {
    const Builder::Word* word = b.word_at(in.current(), in.end());
    if (word == nullptr || !Self::accepts(*word)) return false;
    in.bump(static_cast<std::size_t>(word->end - word->begin));
    return true;
  }
};

struct any_word : word_rule<any_word> {
  static bool accepts(const Builder::Word&) { return true; }
};
template <WordClass C>
struct word_of : word_rule<word_of<C>> {
  static bool accepts(const Builder::Word& w) { return w.word_class == C; }
};
struct identifier : word_of<WordClass::identifier> {};
struct keyword : word_of<WordClass::keyword> {};
struct constant_word : word_of<WordClass::value> {};
struct function_word : word_of<WordClass::function> {};
/// A word that can start an operand.
struct operand_word : word_rule<operand_word> {
  static bool accepts(const Builder::Word& w) { return w.word_class != WordClass::keyword; }
};
template <SymbolId... Ids>
struct one_word : word_rule<one_word<Ids...>> {
  static bool accepts(const Builder::Word& w) { return ((w.id == Ids) || ...); }
};
struct string_function : word_rule<string_function> {
  static bool accepts(const Builder::Word& w) { return returns_text(w.id); }
};

// ---- brackets
// ------------------------------------------------------------------------------------

/// A bracket whose partner exists in the same file and body.
template <char C>
struct paired : predicate<paired<C>> {
  template <typename Input>
  static bool test(Input& in, Builder& b) {
    if (in.empty() || in.peek_char() != C || b.is_stray(in.current())) return false;
    in.bump(1);
    return true;
  }
};

}  // namespace durer::grammar::rules
