// Which rule does what to the builder. Effects are safe where they stand: see expressions.h.
#pragma once

#include "grammar/messages.h"

namespace durer::grammar::rules {

template <typename Rule>
struct on : p::nothing<Rule> {};

template <typename Input>
std::string_view text_of(const Input& in) {
  return {in.begin(), in.size()};
}

/// An action that hands the matched text to a member function of the builder.
template <auto Member>
struct with_text {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    (b.*Member)(text_of(in));
  }
};
/// … its first character.
template <auto Member>
struct with_place {
  template <typename Input>
  static auto apply(const Input& in, Builder& b) {
    return (b.*Member)(in.begin());
  }
};
/// … nothing.
template <auto Member>
struct plainly {
  static void apply0(Builder& b) { (b.*Member)(); }
};
template <Builder::FrameKind Kind>
struct opens {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.open(Kind, in.begin());
  }
};
template <Builder::FrameKind Kind, bool InFunction, bool Arguments = false>
struct opens_in {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.open(Kind, in.begin(), InFunction, Arguments);
  }
};
template <ast::ItemKind Kind>
struct closes {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.close_group(Kind, in.begin());
  }
};

// clang-format off
using Frame = Builder::FrameKind;

// ---- expressions ---------------------------------------------------------------------------------
template <> struct on<number>           : with_text<&Builder::number> {};
template <> struct on<string>           : with_text<&Builder::string> {};
template <> struct on<name>             : with_text<&Builder::name> {};
template <> struct on<any_name>         : with_text<&Builder::name> {};
template <> struct on<scope_name>       : with_text<&Builder::name> {};
template <> struct on<new_name>         : with_text<&Builder::name> {};
template <> struct on<member_name>      : with_text<&Builder::member> {};
template <char C> struct on<mark_of<C>> : with_text<&Builder::token> {};

template <> struct on<prefixed> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) { b.unary(*in.begin(), in.begin()); }
};
template <> struct on<product_tail>     : with_text<&Builder::binary> {};
template <> struct on<sum_tail>         : with_text<&Builder::binary> {};
template <> struct on<relation_tail>    : with_text<&Builder::binary> {};
template <> struct on<logic_tail>       : with_text<&Builder::binary> {};
template <> struct on<choice>           : plainly<&Builder::conditional> {};

template <> struct on<paren_open>       : opens<Frame::paren> {};
template <> struct on<paren_close>      : with_place<&Builder::close_paren> {};
template <> struct on<vector_open>      : opens<Frame::vector> {};
template <> struct on<vector_close>     : with_place<&Builder::close_vector> {};
template <> struct on<index_begin>      : opens<Frame::index> {};
template <> struct on<index>            : plainly<&Builder::close_index> {};
template <> struct on<element>          : plainly<&Builder::close_index> {};
template <> struct on<subscript_open>   : opens<Frame::subscript> {};
template <> struct on<subscript_close>  : with_place<&Builder::close_subscript> {};
template <> struct on<call_open> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) { b.open_call(in.begin()); }
};
template <> struct on<call_close>       : with_place<&Builder::close_call> {};

// ---- items ---------------------------------------------------------------------------------------
template <typename E> struct on<expression_item<E>> : plainly<&Builder::expression_item> {};
template <> struct on<resumed_argument> : plainly<&Builder::resumed_item> {};
template <> struct on<word_item>        : with_text<&Builder::word_item> {};
template <> struct on<mark>             : with_text<&Builder::mark> {};
template <> struct on<comma_mark>       : with_text<&Builder::mark> {};
template <> struct on<block_open>       : opens_in<Frame::braces, false> {};
template <> struct on<function_open>    : opens_in<Frame::braces, true> {};
template <> struct on<brace_close>      : closes<ast::ItemKind::braces> {};
template <> struct on<entry_open>       : opens<Frame::brackets> {};
template <> struct on<entry_close>      : closes<ast::ItemKind::brackets> {};
template <> struct on<end_of_file>      : plainly<&Builder::close_file> {};

// ---- directives ----------------------------------------------------------------------------------
template <SymbolId... Ids> struct on<head_word<Ids...>> : with_text<&Builder::token> {};

template <> struct on<deprecated_word> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) { b.token(text_of(in)); b.deprecated(false); }
};
template <> struct on<deprecated_once> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) { b.token(text_of(in)); b.deprecated(true); }
};
template <SymbolId Word> struct on<declare_head<Word>> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) { b.begin_declare(text_of(in), Word == words::local); }
};
template <> struct on<tuple_open>       : opens_in<Frame::head, false> {};
template <> struct on<tuple_gap>        : plainly<&Builder::tuple_gap> {};
template <> struct on<tuple_close>      : with_text<&Builder::token> {};
template <SymbolId Word> struct on<tuple_head<Word>> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) { b.begin_tuple(text_of(in), Word == words::local); }
};
template <> struct on<closed_by_mark> {
  static void apply0(Builder& b) { b.declared_value(true); }
};
template <> struct on<closed_by_next>   : with_place<&Builder::open_value> {};
template <> struct on<undef>            : with_text<&Builder::undef> {};

template <> struct on<condition_open>   : opens_in<Frame::paren, false> {};
template <> struct on<condition_close>  : with_place<&Builder::close_paren> {};
using BranchKind = ast::Branch::Kind;
template <BranchKind Kind> struct begins_if {
  template <typename Input>
  static void apply(const Input& in, Builder& b) { b.begin_if(text_of(in), Kind); }
};
template <BranchKind Kind> struct begins_branch {
  template <typename Input>
  static void apply(const Input& in, Builder& b) { b.next_branch(text_of(in), Kind); }
};
template <> struct on<if_head>          : begins_if<BranchKind::if_> {};
template <> struct on<ifdef_head>       : begins_if<BranchKind::ifdef> {};
template <> struct on<ifndef_head>      : begins_if<BranchKind::ifndef> {};
template <> struct on<elseif_head>      : begins_branch<BranchKind::if_> {};
template <> struct on<else_head>        : begins_branch<BranchKind::else_> {};
template <> struct on<conditional>      : plainly<&Builder::end_if> {};

using CaseKind = ast::Case::Kind;
template <CaseKind Kind> struct begins_case {
  template <typename Input>
  static void apply(const Input& in, Builder& b) { b.next_case(text_of(in), Kind); }
};
template <> struct on<switch_head>      : with_text<&Builder::begin_switch> {};
template <> struct on<case_head>        : begins_case<CaseKind::case_> {};
template <> struct on<range_head>       : begins_case<CaseKind::range> {};
template <> struct on<otherwise_head>   : begins_case<CaseKind::else_> {};
template <> struct on<switch_block>     : plainly<&Builder::end_switch> {};

template <> struct on<while_head>       : with_text<&Builder::begin_while> {};
template <> struct on<for_open>         : opens_in<Frame::head, false> {};
template <> struct on<for_head>         : with_text<&Builder::begin_for> {};
template <> struct on<macro_param>      : with_text<&Builder::macro_param> {};
template <> struct on<optional_param>   : plainly<&Builder::optional_param> {};
template <> struct on<macro_head>       : with_text<&Builder::begin_macro> {};
template <> struct on<repeated>         : plainly<&Builder::end_loop_or_macro> {};

template <SymbolId Word> constexpr auto text_directive_node() {
  using Kind = ast::Message::Kind;
  if constexpr (Word == words::include) return ast::Include{};
  else if constexpr (Word == words::debug) return ast::Message{Kind::debug, ast::none};
  else if constexpr (Word == words::warning) return ast::Message{Kind::warning, ast::none};
  else if constexpr (Word == words::error) return ast::Message{Kind::error, ast::none};
  else if constexpr (Word == words::render) return ast::Message{Kind::render, ast::none};
  else return ast::Message{Kind::statistics, ast::none};
}
template <SymbolId Word> constexpr auto simple_directive_node() {
  using Kind = ast::Simple::Kind;
  if constexpr (Word == words::default_) return ast::Simple{Kind::default_};
  else if constexpr (Word == words::fopen) return ast::Simple{Kind::fopen};
  else if constexpr (Word == words::fclose) return ast::Simple{Kind::fclose};
  else if constexpr (Word == words::read) return ast::Simple{Kind::read};
  else if constexpr (Word == words::write) return ast::Simple{Kind::write};
  else return ast::Break{};
}
template <SymbolId Word> struct on<text_head<Word>> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) { b.simple_directive(text_of(in), text_directive_node<Word>()); }
};
template <SymbolId Word> struct on<simple_head<Word>> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) { b.simple_directive(text_of(in), simple_directive_node<Word>()); }
};
template <> struct on<version_head> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) { b.simple_directive(text_of(in), ast::Version{}); }
};
template <> struct on<operand_value>    : plainly<&Builder::directive_operand> {};
template <> struct on<version_value>    : plainly<&Builder::directive_operand> {};
template <> struct on<file_open>        : opens_in<Frame::paren, false, true> {};
template <> struct on<file_close> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) { b.close_paren(in.begin()); b.expression_item(); }
};
template <> struct on<unknown_word>     : with_text<&Builder::unknown_word> {};
template <> struct on<unread_word>      : with_text<&Builder::unknown_word> {};
template <> struct on<unknown>          : with_text<&Builder::unknown> {};
template <> struct on<unknown_block>    : with_text<&Builder::unknown> {};
template <> struct on<unknown_head>     : with_text<&Builder::unknown> {};
// clang-format on

}  // namespace durer::grammar::rules
