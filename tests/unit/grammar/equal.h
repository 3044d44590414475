// Equality of trees: everything but places.
#pragma once

#include <algorithm>
#include <bit>

#include "grammar/ast.h"

namespace durer::ast {

inline bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool same(Range a, Range b) { return a.first == b.first && a.count == b.count; }

// clang-format off
inline bool same(const Number& a, const Number& b) { return same(a.value, b.value); }
inline bool same(const String& a, const String& b) { return a.index == b.index; }
inline bool same(const Name& a, const Name& b) { return a.name == b.name; }
inline bool same(const Paren& a, const Paren& b) { return a.inner == b.inner; }
inline bool same(const Vector& a, const Vector& b) { return same(a.components, b.components); }
inline bool same(const Unary& a, const Unary& b) { return a.op == b.op && a.operand == b.operand; }
inline bool same(const Binary& a, const Binary& b) { return a.op == b.op && a.left == b.left && a.right == b.right; }
inline bool same(const Conditional& a, const Conditional& b) { return a.condition == b.condition && a.yes == b.yes && a.no == b.no; }
inline bool same(const Call& a, const Call& b) { return a.callee == b.callee && same(a.args, b.args); }
inline bool same(const Index& a, const Index& b) { return a.name == b.name && same(a.subscripts, b.subscripts); }
inline bool same(const Member& a, const Member& b) { return a.object == b.object && a.member == b.member; }
inline bool same(const OpenGroup& a, const OpenGroup& b) {
  return a.kind == b.kind && a.callee == b.callee && a.name == b.name && same(a.items, b.items);
}
inline bool same(const Declare& a, const Declare& b) {
  return a.local == b.local && a.deprecated == b.deprecated && a.deprecated_once == b.deprecated_once &&
         a.deprecated_message == b.deprecated_message && a.name == b.name && same(a.subscripts, b.subscripts) &&
         a.place == b.place && a.value == b.value && a.semicolon == b.semicolon;
}
inline bool same(const Element& a, const Element& b) { return a.object == b.object && same(a.subscripts, b.subscripts); }
inline bool same(const Tuple& a, const Tuple& b) { return a.local == b.local && a.kind == b.kind && same(a.targets, b.targets); }
inline bool same(const Undef& a, const Undef& b) {
  return a.name == b.name && same(a.subscripts, b.subscripts) && a.place == b.place;
}
inline bool same(const Branch& a, const Branch& b) { return a.kind == b.kind && a.condition == b.condition && same(a.items, b.items); }
inline bool same(const If& a, const If& b) { return same(a.branches, b.branches); }
inline bool same(const While& a, const While& b) { return a.condition == b.condition && same(a.items, b.items); }
inline bool same(const For& a, const For& b) {
  return a.name == b.name && a.start == b.start && a.end == b.end && a.step == b.step && same(a.items, b.items);
}
inline bool same(const Case& a, const Case& b) { return a.kind == b.kind && a.low == b.low && a.high == b.high && same(a.items, b.items); }
inline bool same(const Switch& a, const Switch& b) { return a.value == b.value && same(a.cases, b.cases); }
inline bool same(const Param& a, const Param& b) { return a.name == b.name && a.optional == b.optional; }
inline bool same(const Macro& a, const Macro& b) { return a.name == b.name && same(a.params, b.params) && same(a.items, b.items); }
inline bool same(const Break&, const Break&) { return true; }
inline bool same(const Include& a, const Include& b) { return a.value == b.value; }
inline bool same(const Version& a, const Version& b) { return a.value == b.value; }
inline bool same(const Message& a, const Message& b) { return a.kind == b.kind && a.value == b.value; }
inline bool same(const Simple& a, const Simple& b) { return a.kind == b.kind; }
inline bool same(const Unknown& a, const Unknown& b) { return a.word == b.word; }
inline bool same(const Item& a, const Item& b) { return a.kind == b.kind && a.detail == b.detail && a.ref == b.ref; }
inline bool same(const Group& a, const Group& b) { return same(a.items, b.items); }
// clang-format on

template <typename Variant>
bool same_variant(const Variant& a, const Variant& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&b](const auto& node) { return same(node, std::get<std::decay_t<decltype(node)>>(b)); }, a);
}
inline bool same(const Expr& a, const Expr& b) {
  return a.may_expand == b.may_expand && a.height == b.height && same_variant(a.node, b.node);
}
inline bool same(const Directive& a, const Directive& b) { return same_variant(a.node, b.node); }

template <typename T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const T& x, const T& y) { return same(x, y); });
}

inline bool same(const Tree& a, const Tree& b) {
  return same(a.top, b.top) && same(a.items, b.items) && same(a.exprs, b.exprs) &&
         a.expr_lists == b.expr_lists && same(a.groups, b.groups) &&
         same(a.directives, b.directives) && same(a.branches, b.branches) &&
         same(a.cases, b.cases) && same(a.params, b.params) && a.strings == b.strings &&
         a.utf8 == b.utf8;
}

}  // namespace durer::ast
