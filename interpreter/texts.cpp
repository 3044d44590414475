// Values that are more than numbers: names of things, and strings.
#include <fmt/format.h>

#include "interpreter/interpreter.h"
#include "interpreter/macro_value.h"

namespace durer::interpreter {

namespace w = grammar::words;

/// Whatever the expression stands for: a number, a string, an object, a texture …
Value Interpreter::evaluate_value(const ast::Tree& tree, ast::ExprId id) {
  const ast::Expr& e = tree.exprs[id];
  if (e.may_expand && needs_expansion(tree, id, true)) {
    Nested part(*this, tree, id);
    Value v = read_value();
    accept_punct(';');
    part.finish("the end of this value");
    return v;
  }
  if (const auto* name = std::get_if<ast::Name>(&e.node); name != nullptr) {
    if (!symbols_.reserved(name->name)) {
      const Value* v = lookup(tree, id, true);
      if (!v->defined())
        fail(Code::evaluation, e.span, fmt::format("`{}` has no value", name_of(name->name)));
      return copy_of(*v);
    }
  } else if (array_of(e)) {
    return copy_of(*lookup(tree, id, true));
  }
  if (e.may_expand) {
    if (const MacroRef* macro = value_macro(tree, id, true)) {
      return macro_value(tree, id, *macro, [&](const ast::Tree& t, ast::ExprId value) {
        return evaluate_value(t, value);
      });
    }
  }
  if (is_text(tree, id)) return Value(std::make_shared<const Text>(evaluate_text(tree, id)));
  return Value(evaluate(tree, id, 1));
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
    const Value* v = lookup(tree, id, false);
    return v != nullptr && v->get<Shared<Text>>() != nullptr;
  }
  ast::ExprId callee = ast::none;
  if (const auto* c = std::get_if<ast::Call>(&e.node)) callee = c->callee;
  if (const auto* g = std::get_if<ast::OpenGroup>(&e.node)) {
    if (g->kind == ast::OpenGroup::Kind::call) callee = g->callee;
  }
  if (callee == ast::none) return false;
  const auto* name = std::get_if<ast::Name>(&tree.exprs[callee].node);
  if (name == nullptr) return false;
  switch (name->name) {
    case w::chr:
    case w::concat:
    case w::datetime:
    case w::str:
    case w::strlwr:
    case w::strupr:
    case w::substr:
    case w::vstr: return true;
    default: return false;
  }
}

Text Interpreter::evaluate_text(const ast::Tree& tree, ast::ExprId id, bool file_name) {
  const ast::Expr& e = tree.exprs[id];
  if (e.may_expand && needs_expansion(tree, id, true)) {
    Nested part(*this, tree, id);
    Text t = read_text(file_name);
    part.finish("the end of this string");
    return t;
  }
  if (const auto* s = std::get_if<ast::String>(&e.node)) {
    return decode_literal(tree.strings[s->index], e.span, file_name);
  }
  if (const auto* p = std::get_if<ast::Paren>(&e.node))
    return evaluate_text(tree, p->inner, file_name);
  if (e.may_expand) {
    if (const MacroRef* macro = value_macro(tree, id, true)) {
      return macro_value(tree, id, *macro, [&](const ast::Tree& t, ast::ExprId value) {
        return evaluate_text(t, value, file_name);
      });
    }
  }
  if (!is_text(tree, id)) {
    if (const Value* v = lookup(tree, id, true); v != nullptr) {
      fail(Code::wrong_kind, e.span, fmt::format("expected a string, found {}", kind_name(*v)),
           v->get<Num>() != nullptr ? "turn numbers into strings with `str(X, 0, 3)`" : "");
    }
    fail(Code::wrong_kind, e.span, "expected a string",
         "turn numbers into strings with `str(X, 0, 3)`");
  }
  if (const Value* v = lookup(tree, id, true)) return **v->get<Shared<Text>>();
  if (const auto* c = std::get_if<ast::Call>(&e.node)) {
    const std::span args(tree.expr_lists.data() + c->args.first, c->args.count);
    return call_text_builtin(tree, e, std::get<ast::Name>(tree.exprs[c->callee].node).name, args,
                             nullptr);
  }
  const auto& g = std::get<ast::OpenGroup>(e.node);
  return call_text_builtin(tree, e, std::get<ast::Name>(tree.exprs[g.callee].node).name, {}, &g);
}

/// The second stage of string literals (language §1.4).
Text Interpreter::decode_literal(std::string_view bytes, Span span, bool file_name) {
  Text out;
  const auto hex = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto c = static_cast<unsigned char>(bytes[i]);
    if (c > 127) {
      if (!utf8_) {
        out += version() < 350 ? static_cast<char16_t>(c) : u' ';
        continue;
      }
      const int extra = c >= 0xF0 ? 3 : c >= 0xE0 ? 2 : 1;
      std::uint32_t code = c & (0x3FU >> extra);
      for (int k = 0; k < extra && i + 1 < bytes.size(); ++k) {
        code = code << 6 | (static_cast<unsigned char>(bytes[++i]) & 0x3FU);
      }
      out += code > 0xFFFF ? u'\uFFFD' : static_cast<char16_t>(code);
      continue;
    }
    if (c != '\\' || file_name || i + 1 >= bytes.size()) {
      out += static_cast<char16_t>(c);
      continue;
    }
    const char e = bytes[++i];
    switch (e) {
      case 'a': out += u'\a'; break;
      case 'b': out += u'\b'; break;
      case 'f': out += u'\f'; break;
      case 'n': out += u'\n'; break;
      case 'r': out += u'\r'; break;
      case 't': out += u'\t'; break;
      case 'v': out += u'\v'; break;
      case '\'': out += u'\''; break;
      case '"': out += u'"'; break;
      case '\\': out += u'\\'; break;
      case 'u': {
        int code = 0;
        for (int k = 0; k < 4; ++k) {
          const int digit = i + 1 < bytes.size() ? hex(bytes[i + 1]) : -1;
          if (digit < 0) fail(Code::syntax, span, "`\\u` needs four hexadecimal digits");
          code = code * 16 + digit;
          ++i;
        }
        out += static_cast<char16_t>(code);
        break;
      }
      default:
        fail(Code::syntax, span, fmt::format("unknown escape `\\{}` in a string", e),
             "write `\\\\` for a backslash");
    }
  }
  return out;
}

}  // namespace durer::interpreter
