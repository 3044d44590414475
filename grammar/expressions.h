// Expressions (language §2.2, §6.2). Two levels are read: *additive* nearly everywhere, *full*
// (with relations, logic and `?:`) in parentheses, conditions and function bodies. That decides
// what `<` means: after an additive expression it begins a vector, within a full one it compares.
//
// The rules look one token ahead before an operator, so that they never begin what they cannot
// finish: effects are safe. Only a vector may fail after its first effect (`#if (A) < B #end`), and
// so does `?:`; they are attempts, undone as a whole and remembered as bad.
#pragma once

#include "grammar/tokens.h"

namespace durer::grammar::rules {

template <typename Mode>
struct items;
struct plain_mode;     // additive expressions
struct full_mode;      // full expressions: parentheses, function bodies
struct argument_mode;  // additive ones, continued at full level where that is unambiguous
struct vector_mode;    // components

/// Rule within one more level of nesting.
template <typename Rule>
struct deeper {
  using rule_t = deeper;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode M, template <typename...> class Action,
            template <typename...> class Control, typename Input>
  static bool match(Input& in, Builder& b) {
    b.enter(in.current());
    const bool ok = Control<Rule>::template match<A, M, Action, Control>(in, b);
    b.leave();
    return ok;
  }
};

/// Rule, or nothing at all: what it did to the builder is undone when it fails. A place where it
/// failed is not tried again, which keeps nested attempts linear.
template <typename Rule>
struct attempt {
  using rule_t = attempt;
  using subs_t = p::type_list<Rule>;
  template <p::apply_mode A, p::rewind_mode, template <typename...> class Action,
            template <typename...> class Control, typename Input>
  static bool match(Input& in, Builder& b) {
    const char* const at = in.current();
    if (b.known_bad(at)) return false;
    const auto checkpoint = b.checkpoint();
    try {
      if (Control<Rule>::template match<A, p::rewind_mode::required, Action, Control>(in, b)) {
        return true;
      }
    } catch (const Failure& f) {
      if (f.final()) throw;
      in.iterator() = at;
    }
    b.rollback(checkpoint);
    b.remember_bad(at);
    return false;
  }
};

// clang-format off

/// A one-character token; its end counts for spans.
template <char C>
struct mark_of          : p::one<C> {};
struct comma            : p::seq<mark_of<','>, gap> {};

// ---- looking ahead -------------------------------------------------------------------------------

struct prefix           : p::sor<p::one<'+', '-'>, p::seq<p::one<'!'>, p::not_at<p::one<'='>>>> {};
struct less             : p::seq<p::one<'<'>, p::not_at<p::one<'='>>> {};
struct greater          : p::seq<p::one<'>'>, p::not_at<p::one<'='>>> {};
/// The scopes as dictionaries: `local.X` (since 3.8); elsewhere `local` is no operand.
struct scope_ahead      : p::at<one_word<words::local>, gap, p::one<'.', '['>> {};
struct primary_start    : p::sor<p::digit, p::seq<p::one<'.'>, p::digit>, paired<'('>, less, operand_word, scope_ahead> {};
struct operand_start    : p::seq<p::star<prefix, gap>, primary_start> {};
struct additive_start   : p::sor<p::one<'"'>, operand_start> {};

/// An operator, if an operand follows.
template <typename Operator, typename Operand>
struct infix            : p::seq<p::at<Operator, gap, Operand>, Operator, gap> {};

// ---- primaries -----------------------------------------------------------------------------------

struct paren_open       : paired<'('> {};
struct paren_close      : paired<')'> {};
struct paren            : p::seq<paren_open, gap, deeper<items<full_mode>>, p::must<paren_close>, gap> {};

struct vector_open      : less {};
struct vector_close     : greater {};
struct not_closed       : predicate<not_closed> {
  template <typename Input>
  static bool test(Input& in, Builder& b) { b.stopped_at(in.current()); return false; }
};
struct vector_text      : p::seq<vector_open, gap, deeper<items<vector_mode>>, p::sor<vector_close, not_closed>, gap> {};
struct vector;

struct name             : operand_word {};
struct subscript_open   : paired<'['> {};
struct subscript_close  : paired<']'> {};
struct subscript        : p::seq<subscript_open, gap, deeper<items<plain_mode>>, p::must<subscript_close>, gap> {};
struct index_begin      : p::at<paired<'['>> {};
struct index            : p::seq<index_begin, p::plus<subscript>> {};

struct call_open        : paired<'('> {};
struct call_close       : paired<')'> {};
struct call             : p::seq<call_open, gap, deeper<items<argument_mode>>, p::must<call_close>, gap> {};

struct variable         : p::seq<p::at<identifier>, name, gap, p::opt<index>, p::opt<call>> {};
struct built_in         : p::seq<p::at<function_word>, name, gap, p::opt<call>> {};
struct constant         : p::seq<p::at<constant_word>, name, gap> {};

struct scope_name       : any_word {};
struct scope            : p::seq<scope_ahead, scope_name, gap, p::opt<index>> {};

struct number_value     : p::seq<number, gap> {};
struct primary          : p::sor<number_value, vector, variable, constant, built_in, scope, paren> {};

// `V.x`, and entries of dictionaries: `D.list[2].name`, `D.f(3)`.
struct member_name      : any_word {};
struct member           : p::seq<p::one<'.'>, gap, member_name, gap> {};
struct entry_before     : predicate<entry_before> {
  template <typename Input>
  static bool test(Input&, Builder& b) { return b.after_entry(); }
};
struct element          : p::seq<index_begin, p::plus<subscript>> {};
struct entry_member     : p::seq<member, p::opt<entry_before, element>> {};
struct entry_path       : p::seq<entry_member, p::star<entry_before, entry_member>> {};
struct members          : p::seq<entry_path, p::opt<entry_before, call>> {};

// ---- the additive level --------------------------------------------------------------------------

struct operand;
struct prefixed         : p::seq<p::at<prefix, gap, operand_start>, prefix, gap, p::must<deeper<operand>>> {};
struct operand          : p::sor<p::seq<primary, p::opt<members>>, prefixed> {};

struct product_tail     : p::seq<infix<p::one<'*', '/'>, operand_start>, p::must<operand>> {};
struct product          : p::seq<operand, p::star<product_tail>> {};
struct sum_tail         : p::seq<infix<p::one<'+', '-'>, operand_start>, p::must<product>> {};
struct sum              : p::seq<product, p::star<sum_tail>> {};

// Text takes no operator but relations: a sign after it belongs to whatever follows.
struct text_call        : p::seq<p::at<string_function, gap, paired<'('>>, name, gap, call> {};
struct text             : p::seq<p::sor<p::seq<string, gap>, text_call>> {};
struct additive         : p::sor<text, sum> {};

// ---- the full level ------------------------------------------------------------------------------

struct relation_mark    : p::sor<p::seq<p::one<'<', '>'>, p::opt<p::one<'='>>>, p::one<'='>, p::string<'!', '='>> {};
struct relation_tail    : p::seq<infix<relation_mark, additive_start>, p::must<additive>> {};
struct relation         : p::seq<additive, p::star<relation_tail>> {};
struct logic_tail       : p::seq<infix<p::one<'&', '|'>, additive_start>, p::must<relation>> {};
struct full;
struct choice           : p::seq<p::one<'?'>, gap, deeper<full>, mark_of<':'>, gap, deeper<full>> {};
struct choice_tail      : p::seq<p::at<p::one<'?'>>, attempt<choice>> {};
struct full_tails       : p::seq<p::star<relation_tail>, p::star<logic_tail>, p::opt<choice_tail>> {};
struct full             : p::seq<additive, full_tails> {};

// In arguments a `<` after an operand may begin the next argument, other marks cannot.
struct clear_mark       : p::sor<p::one<'=', '>', '&', '|', '?'>, p::string<'!', '='>, p::string<'<', '='>> {};
struct argument         : p::seq<additive, p::opt<p::at<clear_mark>, full_tails>> {};
// It did not begin one: so it compares.
struct resume           : predicate<resume> {
  template <typename Input>
  static bool test(Input&, Builder& b) { return b.resume_expression(); }
};
struct resumed_argument : p::seq<p::at<less, gap, additive_start>, resume, relation_tail, full_tails> {};

// clang-format on

/// `<a, b, c>`. Where no vector can be meant, or a directive next to it might explain the mark, it
/// only does not match; otherwise a half vector is a failure.
struct vector {
  using rule_t = vector;
  using subs_t = p::type_list<vector_text>;
  template <p::apply_mode A, p::rewind_mode, template <typename...> class Action,
            template <typename...> class Control, typename Input>
  static bool match(Input& in, Builder& b) {
    const char* const at = in.current();
    if (in.empty() || *at != '<' || b.known_bad(at)) return false;
    const bool first = b.item_starts_at(at);
    if (first && b.relation_only()) return false;
    const bool compares = first && b.relation_possible(false);
    const auto checkpoint = b.checkpoint();
    Failure why;
    bool seen = false;
    try {
      if (Control<vector_text>::template match<A, p::rewind_mode::required, Action, Control>(in,
                                                                                             b)) {
        if (!compares || !b.made_single_component()) return true;
        in.iterator() = at;  // `f(a < b > c)`: two relations
        b.rollback(checkpoint);
        b.remember_bad(at);
        return false;
      }
      if (*at == '<' && at[1] == '=') return false;
      why = b.failure(b.stopped(), "a component, `,` or `>`", Failure::Kind::vector);
      seen = b.directive_seen();
    } catch (const Failure& f) {
      if (f.final()) throw;
      in.iterator() = at;
      why = f;
    }
    b.rollback(checkpoint);
    b.remember_bad(at);
    if (first && b.relation_possible(seen)) return false;
    why.after_operand = why.kind == Failure::Kind::vector && first && b.after_operand();
    throw why;
  }
};

}  // namespace durer::grammar::rules
