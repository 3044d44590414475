// Directives (language §4). Their bodies are items; the scan has made sure that each has its
// `#end`.
#pragma once

#include <algorithm>

#include "grammar/items.h"

namespace durer::grammar::rules {

// clang-format off

/// A word of a head: where it ends matters for the span of the head.
template <SymbolId... Ids>
struct head_word        : one_word<Ids...> {};
/// `#` and one of these words.
template <SymbolId... Ids>
struct hash             : p::seq<p::one<'#'>, gap, head_word<Ids...>, gap> {};

// ---- shared parts --------------------------------------------------------------------------------

struct opening          : p::seq<paired<'('>, gap> {};
struct closing          : p::seq<mark_of<')'>, gap> {};
struct semicolon        : p::seq<mark_of<';'>, gap> {};

struct condition_open   : paired<'('> {};
struct condition_close  : paired<')'> {};
struct condition        : p::seq<condition_open, gap, deeper<items<full_mode>>, p::must<condition_close>, gap> {};

struct any_name         : any_word {};
struct lvalue           : p::seq<any_name, gap, p::opt<index>, p::opt<entry_path>> {};
struct new_name         : identifier {};
struct new_lvalue       : p::seq<p::sor<scope, p::seq<new_name, gap, p::opt<index>>>, p::opt<entry_path>> {};
struct bound            : additive {};

struct body             : deeper<items<plain_mode>> {};
struct block_end        : hash<words::end> {};

// ---- declarations --------------------------------------------------------------------------------

struct deprecated_once  : head_word<words::once> {};
struct deprecated_word  : head_word<words::deprecated> {};
struct deprecated       : p::seq<deprecated_word, gap, p::opt<deprecated_once, gap>, p::opt<text>> {};
struct equals           : p::seq<mark_of<'='>, gap> {};
template <SymbolId Word>
struct declare_head     : p::seq<hash<Word>, p::opt<deprecated>, p::must<new_lvalue, equals>> {};
struct any_declare_head : p::sor<declare_head<words::declare>, declare_head<words::local>> {};

// A value that is not closed here becomes the item after the directive (ast::Declare).
struct closed_by_mark   : p::seq<semicolon, p::opt<semicolon>> {};  // the oracle takes one more
struct closed_by_next   : p::success {};
struct declared_value   : p::seq<additive, p::sor<closed_by_mark, closed_by_next>> {};
struct declare          : p::seq<any_declare_head, p::opt<declared_value>> {};

// Several targets at once (since 3.8). The value becomes the items after the directive.
struct tuple_mark       : p::one<'(', '<', '{'> {};
struct tuple_open       : tuple_mark {};
struct tuple_end        : p::one<')', '>', '}'> {};
struct tuple_close      : tuple_end {};
struct tuple_gap        : p::at<p::sor<p::one<','>, tuple_end>> {};
struct tuple_target     : p::sor<tuple_gap, p::must<new_lvalue>> {};
struct tuple_list       : p::seq<tuple_target, p::star<comma, tuple_target>> {};
template <SymbolId Word>
struct tuple_head       : p::seq<p::at<hash<Word>, tuple_mark>, hash<Word>, tuple_open, gap, tuple_list,
                                 p::must<tuple_close>, gap, p::must<equals>> {};
struct tuple            : p::sor<tuple_head<words::declare>, tuple_head<words::local>> {};

struct undef            : p::seq<hash<words::undef>, p::must<lvalue>> {};

// ---- conditionals --------------------------------------------------------------------------------

struct if_head          : p::seq<hash<words::if_>, p::must<condition>> {};
struct ifdef_head       : p::seq<hash<words::ifdef>, p::must<opening, lvalue, closing>> {};
struct ifndef_head      : p::seq<hash<words::ifndef>, p::must<opening, lvalue, closing>> {};
struct elseif_head      : p::seq<hash<words::elseif>, p::must<condition>> {};
struct else_head        : hash<words::else_> {};
struct conditional      : p::seq<p::sor<if_head, ifdef_head, ifndef_head>, body,
                                 p::star<elseif_head, body>, p::star<else_head, body>, p::must<block_end>> {};

struct switch_head      : p::seq<hash<words::switch_>, p::must<condition>> {};
struct first_case       : p::at<hash<words::case_, words::range, words::else_, words::end>> {};
struct case_head        : p::seq<hash<words::case_>, p::must<condition>> {};
struct range_head       : p::seq<hash<words::range>, p::must<opening, bound>, p::opt<comma>, p::must<bound, closing>> {};
struct otherwise_head   : hash<words::else_> {};
struct switch_block     : p::seq<switch_head, p::must<first_case>,
                                 p::star<p::sor<case_head, range_head>, body>,
                                 p::star<otherwise_head, body>, p::must<block_end>> {};

// ---- loops and macros ----------------------------------------------------------------------------

struct while_head       : p::seq<hash<words::while_>, p::must<condition>> {};
struct for_open         : paired<'('> {};
struct for_head         : p::seq<hash<words::for_>, p::must<for_open>, gap, p::must<new_name>, gap, p::opt<comma>,
                                 p::must<bound>, p::opt<comma>, p::must<bound>, p::opt<comma>, p::opt<bound>,
                                 p::must<closing>> {};
struct macro_param      : identifier {};
struct optional_word    : one_word<additions::optional> {};
struct optional_param   : p::seq<p::at<optional_word, gap, identifier>, optional_word, gap, macro_param> {};
struct macro_params     : p::star<p::sor<optional_param, macro_param>, gap, p::opt<comma>> {};
struct params_end       : closing {};
struct macro_head       : p::seq<hash<words::macro>, p::must<new_name>, gap, p::must<opening>, macro_params,
                                 p::must<params_end>> {};
struct repeated         : p::seq<p::sor<while_head, for_head, macro_head>, body, p::must<block_end>> {};

// ---- directives with operands --------------------------------------------------------------------

struct operand_value    : p::sor<text, p::seq<primary, p::opt<members>>> {};
struct version_value    : additive {};
template <SymbolId Word>
struct text_head        : hash<Word> {};
struct text_directive   : p::seq<p::sor<text_head<words::include>, text_head<words::debug>, text_head<words::warning>,
                                        text_head<words::error>, text_head<words::render>,
                                        text_head<words::statistics>>,
                                 p::opt<operand_value>> {};
struct version_head     : hash<words::version> {};
struct unofficial       : p::seq<p::keyword<'u', 'n', 'o', 'f', 'f', 'i', 'c', 'i', 'a', 'l'>, gap> {};
struct version          : p::seq<version_head, p::opt<unofficial>, p::opt<version_value, p::opt<semicolon>>> {};

template <SymbolId Word>
struct simple_head      : hash<Word> {};
struct file_open        : paired<'('> {};
struct file_close       : paired<')'> {};
struct file_arguments   : p::seq<file_open, gap, deeper<items<argument_mode>>, p::must<file_close>, gap> {};
struct file_directive   : p::seq<p::sor<simple_head<words::read>, simple_head<words::write>>, p::opt<file_arguments>> {};
struct simple_directive : p::sor<simple_head<words::default_>, simple_head<words::fopen>, simple_head<words::fclose>,
                                 simple_head<words::break_>> {};

// ---- any directive -------------------------------------------------------------------------------

struct terminator       : hash<words::end, words::else_, words::elseif, words::case_, words::range> {};
// Outside of a body an unknown directive cannot be skipped: it is an error at once.
struct skippable        : predicate<skippable> {
  template <typename Input>
  static bool test(Input& in, Builder& b) {
    if (!b.in_body()) throw b.failure(in.current(), {}, Failure::Kind::directive);
    return true;
  }
};
struct unknown_word     : identifier {};
struct unknown          : p::seq<p::not_at<terminator>, p::one<'#'>, gap, skippable, unknown_word, gap> {};
// Before anything that is neither a directive nor a number, a `#` means nothing: `look_at 0 # }`.
struct directive_word   : one_word<words::break_, words::case_, words::debug, words::declare, words::default_,
                                   words::else_, words::elseif, words::end, words::error, words::fclose, words::fopen,
                                   words::for_, words::if_, words::ifdef, words::ifndef, words::include, words::local,
                                   words::macro, words::range, words::read, words::render, words::statistics,
                                   words::switch_, words::undef, words::version, words::warning, words::while_,
                                   words::write> {};
struct plain_word       : p::seq<p::not_at<directive_word>, keyword> {};
// A name that no misspelled directive has: all of theirs are letters, and few people write capitals.
struct unlike_directive : word_rule<unlike_directive> {
  static bool accepts(const Builder::Word& word) {
    const auto lower = [](char c) { return c >= 'a' && c <= 'z'; };
    return !std::all_of(word.begin, word.end, lower) && !is_directive_in_capitals({word.begin, word.end});
  }
};
struct after_lone_hash  : p::sor<plain_word, unlike_directive, p::not_at<p::sor<any_word, number>>> {};
struct lone_hash        : p::seq<p::one<'#'>, gap, p::at<after_lone_hash>> {};

struct directive_ahead  : p::seq<p::not_at<lone_hash>, p::one<'#'>> {};
struct directive        : p::seq<p::at<p::one<'#'>>,
                                 p::sor<tuple, declare, conditional, repeated, switch_block, text_directive, file_directive,
                                        version, simple_directive, undef, lone_hash, unknown>> {};

// ---- what is left of text that cannot be read ----------------------------------------------------

struct block_word       : one_word<words::if_, words::ifdef, words::ifndef, words::while_, words::for_,
                                   words::switch_, words::macro> {};
struct unread_block;
struct unread_token     : p::sor<word_text, number, string, p::seq<p::not_one<'#'>>,
                                 p::seq<p::one<'#'>, gap, p::not_at<one_word<words::end>>>> {};
struct unread_text      : p::seq<p::star<gap, p::sor<deeper<unread_block>, unread_token>>, gap> {};
struct unread_block     : p::seq<p::one<'#'>, gap, block_word, unread_text, p::one<'#'>, gap, one_word<words::end>, gap> {};
// A malformed `#if` or `#macro` is dropped with all that belongs to it.
struct unread_word      : any_word {};
struct unknown_block    : p::seq<p::at<p::one<'#'>, gap, block_word>, p::one<'#'>, gap, unread_word, p::disable<unread_text>,
                                 p::disable<p::one<'#'>, gap, one_word<words::end>, gap>> {};
struct unknown_head     : p::seq<p::not_at<terminator>, p::one<'#'>, gap, unread_word, gap> {};
struct fallback_value   : p::seq<p::sor<p::seq<string>, number, name>, gap> {};
struct fallback         : p::sor<attempt<any_declare_head>, unknown_block, unknown_head,
                                 expression_item<fallback_value>,
                                 p::seq<p::sor<word_item, comma_item, mark>, gap>> {};

// ---- the file ------------------------------------------------------------------------------------

struct end_of_file      : p::eof {};
struct file             : p::seq<gap, items<plain_mode>, p::must<end_of_file>> {};
// clang-format on

}  // namespace durer::grammar::rules
