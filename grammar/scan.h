// The scan: every token of the file once, for lexical errors and for the pairing of brackets and
// directives. What it accepts, the grammar proper can rely on: strings and comments end, every
// directive has its `#end`, and each bracket knows whether it has a partner.
#pragma once

#include <fmt/format.h>

#include "grammar/balance.h"
#include "grammar/literals.h"
#include "grammar/tokens.h"

namespace durer::grammar {

struct Scan {
  const char* begin;
  Loc base;
  Balance& balance;
  Diagnostics& diagnostics;
  LiteralRuns& runs;
  std::string_view word;
  std::size_t errors = 0;

  /// Reports and goes on: one run may find several lexical errors, but not a flood of them.
  void error(Code code, const char* from, const char* to, std::string message, std::string at) {
    if (++errors > 20) return;
    Diagnostic d;
    d.code = code;
    d.span = {static_cast<Loc>(base + (from - begin)), static_cast<std::uint32_t>(to - from)};
    d.message = std::move(message);
    d.at = std::move(at);
    diagnostics.report(std::move(d));
  }
};

}  // namespace durer::grammar

namespace durer::grammar::rules {

// clang-format off
struct scan_number      : number {};
struct second_point     : p::one<'.'> {};
struct scan_string      : string {};

struct scan_word        : word_text {};
struct call_mark        : p::at<p::one<'('>> {};
struct scan_name        : p::seq<scan_word, gap, p::opt<call_mark>> {};

struct macro_word       : p::keyword<'m', 'a', 'c', 'r', 'o'> {};
struct macro_hash       : p::seq<p::one<'#'>, gap, macro_word> {};
struct scan_macro_name  : word_text {};
struct scan_directive   : word_text {};
struct directive_hash   : p::seq<p::one<'#'>, gap, scan_directive> {};

struct open_bracket     : p::one<'{', '(', '['> {};
struct close_bracket    : p::one<'}', ')', ']'> {};
struct operator_mark    : p::one<'<', '+', '-', '*', '/', '=', '>', '&', '|', '?', '!', '.'> {};
struct other_mark       : p::one<',', ';', ':', '^', '@', '$', '%', '~', '`', '\'', '\\'> {};

struct rest             : p::star<p::any> {};
struct open_string      : p::seq<p::one<'"'>, rest> {};
struct open_comment     : p::seq<p::string<'/', '*'>, rest> {};
struct foreign_bytes    : p::plus<p::not_range<'\0', '\x7E'>> {};
struct control_byte     : p::any {};

struct lone_hash_mark   : p::one<'#'> {};
struct scan_literals    : predicate<scan_literals> {
  template <typename Input>
  static bool test(Input& in, Scan& s) {
    if (in.empty() || !may_begin_literal(in.peek_char())) return false;
    const LiteralRun* run = s.runs.find(s.begin, in.current(), in.end());
    if (run != nullptr) in.bump(run->text.size());
    return run != nullptr;
  }
};
struct lexeme           : p::sor<blank, scan_literals,
                                 p::seq<scan_number, p::opt<second_point>>,
                                 scan_name,
                                 other_mark, open_bracket, close_bracket,
                                 line_comment, block_comment, open_comment, operator_mark,
                                 scan_string, open_string,
                                 p::seq<macro_hash, gap, p::opt<scan_macro_name>>, directive_hash, lone_hash_mark,
                                 foreign_bytes, control_byte> {};
struct scan             : p::seq<p::star<lexeme>, p::eof> {};
// clang-format on

template <typename Rule>
struct on_scan : p::nothing<Rule> {};

template <>
struct on_scan<scan_number> {
  static void apply0(Scan& s) { ++s.balance.operands; }
};
template <>
struct on_scan<second_point> {
  template <typename Input>
  static void apply(const Input& in, Scan& s) {
    s.error(Code::syntax, in.begin(), in.end(), "a number has only one decimal point",
            "second point");
  }
};
template <>
struct on_scan<scan_string> {
  static void apply0(Scan& s) { ++s.balance.operands; }
};
template <>
struct on_scan<scan_word> {
  template <typename Input>
  static void apply(const Input& in, Scan& s) {
    ++s.balance.operands;
    s.word = {in.begin(), in.size()};
  }
};
template <>
struct on_scan<call_mark> {
  template <typename Input>
  static void apply(const Input& in, Scan& s) {
    s.balance.call(s.word, static_cast<std::size_t>(in.begin() - s.begin));
  }
};
template <>
struct on_scan<scan_directive> {
  template <typename Input>
  static void apply(const Input& in, Scan& s) {
    s.word = {in.begin(), in.size()};
  }
};
template <>
struct on_scan<directive_hash> {
  template <typename Input>
  static void apply(const Input& in, Scan& s) {
    s.balance.directive(s.word, static_cast<std::size_t>(in.begin() - s.begin), in.size());
  }
};
template <>
struct on_scan<macro_hash> {
  template <typename Input>
  static void apply(const Input& in, Scan& s) {
    s.balance.directive("macro", static_cast<std::size_t>(in.begin() - s.begin), in.size());
  }
};
template <>
struct on_scan<scan_macro_name> {
  template <typename Input>
  static void apply(const Input& in, Scan& s) {
    ++s.balance.operands;
    s.balance.macro_name({in.begin(), in.size()});
  }
};
template <>
struct on_scan<operator_mark> {
  static void apply0(Scan& s) { ++s.balance.operators; }
};
template <>
struct on_scan<other_mark> {
  static void apply0(Scan& s) { ++s.balance.marks; }
};
template <>
struct on_scan<open_bracket> {
  template <typename Input>
  static void apply(const Input& in, Scan& s) {
    ++s.balance.operators;
    s.balance.open(*in.begin(), static_cast<std::size_t>(in.begin() - s.begin));
  }
};
template <>
struct on_scan<close_bracket> {
  template <typename Input>
  static void apply(const Input& in, Scan& s) {
    s.balance.close(*in.begin(), static_cast<std::size_t>(in.begin() - s.begin));
  }
};
template <>
struct on_scan<open_string> {
  template <typename Input>
  static void apply(const Input& in, Scan& s) {
    s.error(Code::unterminated, in.begin(), in.begin() + 1, "no matching `\"`",
            "this string never ends");
  }
};
template <>
struct on_scan<open_comment> {
  template <typename Input>
  static void apply(const Input& in, Scan& s) {
    s.error(Code::unterminated, in.begin(), in.begin() + 2, "no matching `*/`",
            "this comment never ends");
  }
};
template <>
struct on_scan<foreign_bytes> {
  template <typename Input>
  static void apply(const Input& in, Scan& s) {
    s.error(Code::bad_character, in.begin(), in.end(),
            "only ASCII characters can stand outside of strings and comments", "not ASCII");
  }
};
template <>
struct on_scan<control_byte> {
  template <typename Input>
  static void apply(const Input& in, Scan& s) {
    s.error(Code::bad_character, in.begin(), in.end(),
            fmt::format("control character 0x{:02X} cannot stand in a scene file",
                        static_cast<unsigned char>(*in.begin())),
            "this byte");
  }
};

}  // namespace durer::grammar::rules
