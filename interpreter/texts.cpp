// Values that are more than numbers: names of things, and strings.
#include <algorithm>

#include <fmt/format.h>

#include "interpreter/interpreter.h"
#include "interpreter/macro_value.h"

namespace durer::interpreter {

namespace w = grammar::words;

/// Whatever the expression stands for: a number, a string, an object, a texture …
Value Interpreter::evaluate_value(const ast::Tree& tree, ast::ExprId id) {
  const ast::Expr& e = tree.exprs[id];
  if (const Operand* quickly = quick(tree, id, 1)) return take_result(*quickly);
  if (e.may_expand && needs_expansion(tree, id, true)) {
    Nested part(*this, tree, id);
    Value v = read_value();
    accept_punct(';');
    part.finish("the end of this value");
    return v;
  }
  if (const auto* name = std::get_if<ast::Name>(&e.node); name != nullptr) {
    if (name->name == grammar::additions::dictionary && additions_ &&
        env_.find(name->name) == nullptr) {
      return Value(std::make_shared<Dictionary>());
    }
    if (!symbols_.reserved(name->name)) {
      const Value* v = lookup(tree, id, true);
      if (!v->defined())
        fail(Code::evaluation, e.span, fmt::format("`{}` has no value", name_of(name->name)));
      check_copyable(*v, name->name, e.span);
      return copy_of(*v);
    }
  } else if (array_of(e)) {
    return copy_of(*lookup(tree, id, true));
  } else if (additions_) {
    if (const Value* v = entry(tree, id, true)) return copy_of(*v);
  }
  if (e.may_expand) {
    if (const MacroRef* macro = value_macro(tree, id, true)) {
      return macro_value(tree, id, *macro, [&](const ast::Tree& t, ast::ExprId value) {
        return evaluate_value(t, value);
      });
    }
  }
  if (is_text(tree, id)) return text_value(evaluate_text(tree, id));
  return Value(evaluate(tree, id, 1));
}

Value Interpreter::take_result(const Operand& result) {
  if (result.is_text()) {
    Text text;
    machine_.take_text(text);
    return text_value(std::move(text));
  }
  return Value(result.number());
}

void Interpreter::check_copyable(const Value& v, SymbolId name, Span span) {
  if (v.get<MacroRef>() != nullptr) {
    fail(Code::wrong_kind, span, fmt::format("`{}` is a macro", name_of(name)),
         fmt::format("call it: `{}()`", name_of(name)));
  }
  if (v.get<std::shared_ptr<DataFile>>() != nullptr) {
    fail(Code::wrong_kind, span, fmt::format("`{}` is an open file and has no copy", name_of(name)));
  }
}

/// Assignment copies; arrays are shared until one of the copies is written.
Value Interpreter::copy_of(const Value& v) { return v; }

// ---- strings
// --------------------------------------------------------------------------------------

bool Interpreter::is_text(const ast::Tree& tree, ast::ExprId id) {
  const ast::Expr& e = tree.exprs[id];
  if (std::holds_alternative<ast::Binary>(e.node) || std::holds_alternative<ast::Number>(e.node) ||
      std::holds_alternative<ast::Vector>(e.node)) {
    return false;
  }
  if (std::holds_alternative<ast::String>(e.node)) return true;
  if (const auto* p = std::get_if<ast::Paren>(&e.node)) return is_text(tree, p->inner);
  if (std::holds_alternative<ast::Name>(e.node) || array_of(e)) {
    const Peek peek(*this);
    const Value* v = lookup(tree, id, false);
    return v != nullptr && v->get<Shared<Text>>() != nullptr;
  }
  if (additions_) {
    if (const Value* v = entry(tree, id, false)) return v->get<Shared<Text>>() != nullptr;
  }
  return text_function(tree, id) != grammar::SymbolTable::none;
}

/// The string function that the expression calls; `none` for other expressions.
SymbolId Interpreter::text_function(const ast::Tree& tree, ast::ExprId id) {
  constexpr SymbolId none = grammar::SymbolTable::none;
  const ast::Expr& e = tree.exprs[id];
  ast::ExprId callee = ast::none;
  if (const auto* c = std::get_if<ast::Call>(&e.node)) callee = c->callee;
  if (const auto* g = std::get_if<ast::OpenGroup>(&e.node)) {
    if (g->kind == ast::OpenGroup::Kind::call) callee = g->callee;
  }
  if (callee == ast::none) return none;
  const auto* name = std::get_if<ast::Name>(&tree.exprs[callee].node);
  if (name == nullptr) return none;
  switch (name->name) {
    case w::chr:
    case w::concat:
    case w::datetime:
    case w::str:
    case w::strlwr:
    case w::strupr:
    case w::substr:
    case w::vstr: return name->name;
    default: return none;
  }
}

Text Interpreter::evaluate_text(const ast::Tree& tree, ast::ExprId id, bool file_name) {
  Text out;
  append_text(tree, id, out, file_name);
  return out;
}

void Interpreter::append_text(const ast::Tree& tree, ast::ExprId id, Text& out, bool file_name) {
  const ast::Expr& e = tree.exprs[id];
  if (const Operand* quickly = quick(tree, id, 1); quickly != nullptr && quickly->is_text()) {
    return out.append(*quickly->string);
  }
  if (e.may_expand && needs_expansion(tree, id, true)) {
    Nested part(*this, tree, id);
    out.append(read_text(file_name));
    part.finish("the end of this string");
    return;
  }
  if (const auto* s = std::get_if<ast::String>(&e.node)) {
    decode_literal(tree.strings[s->index], e.span, file_name, out);
    return;
  }
  if (const auto* p = std::get_if<ast::Paren>(&e.node)) {
    return append_text(tree, p->inner, out, file_name);
  }
  if (e.may_expand) {
    if (const MacroRef* macro = value_macro(tree, id, true)) {
      macro_value(tree, id, *macro, [&](const ast::Tree& t, ast::ExprId value) {
        append_text(t, value, out, file_name);
      });
      return;
    }
  }
  if (const SymbolId function = text_function(tree, id); function != grammar::SymbolTable::none) {
    if (const auto* c = std::get_if<ast::Call>(&e.node)) {
      const std::span args(tree.expr_lists.data() + c->args.first, c->args.count);
      return append_text_call(tree, e, function, args, nullptr, out);
    }
    return append_text_call(tree, e, function, {}, std::get_if<ast::OpenGroup>(&e.node), out);
  }
  const Value* v = lookup(tree, id, true);
  if (v == nullptr) {
    fail(Code::wrong_kind, e.span, "expected a string",
         "turn numbers into strings with `str(X, 0, 3)`");
  }
  const auto* text = v->get<Shared<Text>>();
  if (text == nullptr) {
    fail(Code::wrong_kind, e.span, fmt::format("expected a string, found {}", kind_name(*v)),
         v->get<Num>() != nullptr ? "turn numbers into strings with `str(X, 0, 3)`" : "");
  }
  out.append(**text);
}

/// The second stage of string literals (language §1.4).
void Interpreter::decode_literal(std::string_view bytes, Span span, bool file_name, Text& out) {
  if (std::ranges::all_of(bytes, [](char c) { return c > 0 && c != '\\'; })) {
    out.append(bytes);
    return;
  }
  const auto hex = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto c = static_cast<unsigned char>(bytes[i]);
    if (c > 127) {
      decode_high_bytes(bytes, i, span, out);
      continue;
    }
    if (c != '\\' || file_name || i + 1 >= bytes.size()) {
      out.append(static_cast<char16_t>(c));
      continue;
    }
    const char e = bytes[++i];
    switch (e) {
      case 'a': out.append(u'\a'); break;
      case 'b': out.append(u'\b'); break;
      case 'f': out.append(u'\f'); break;
      case 'n': out.append(u'\n'); break;
      case 'r': out.append(u'\r'); break;
      case 't': out.append(u'\t'); break;
      case 'v': out.append(u'\v'); break;
      case '\'': out.append(u'\''); break;
      case '"': out.append(u'"'); break;
      case '\\': out.append(u'\\'); break;
      case 'u': {
        int code = 0;
        for (int k = 0; k < 4; ++k) {
          const int digit = i + 1 < bytes.size() ? hex(bytes[i + 1]) : -1;
          if (digit < 0) fail(Code::syntax, span, "`\\u` needs four hexadecimal digits");
          code = code * 16 + digit;
          ++i;
        }
        out.append(static_cast<char16_t>(code));
        break;
      }
      default:
        fail(Code::syntax, span, fmt::format("unknown escape `\\{}` in a string", e),
             "write `\\\\` for a backslash");
    }
  }
}

}  // namespace durer::interpreter
