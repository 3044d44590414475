// Long lists of literals (grammar/literals.h): token by token for readers that do not expect them.
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace {
// Readers look a token or two ahead; what they have seen must stay.
constexpr std::uint32_t slots = 16;
constexpr std::uint32_t most_components = 5;
constexpr std::uint32_t exprs_per_slot = 1 + most_components;
}  // namespace

void Interpreter::push_literals(const ast::Tree& tree, const ast::Item& item) {
  Frame& f = push(Frame::Kind::literals, item.span);
  f.tree = &tree;
  f.node = item.ref;
  f.end = static_cast<std::uint32_t>(tree.literals[item.ref].text.size());
}

bool Interpreter::step_literals(Token& token) {
  Frame& f = frames_.back();
  if (f.pos >= f.end) {
    pop();
    return false;
  }
  const grammar::LiteralRun& run = f.tree->literals[f.node];
  grammar::LiteralReader reader(run, f.pos);
  const Span here{f.call.begin + f.pos, 1};
  if (f.at_comma) {
    reader.comma();
    f.at_comma = false;
    f.pos = static_cast<std::uint32_t>(reader.offset(run));
    token = Token{};
    token.kind = Token::Kind::punct;
    token.punct = ',';
    token.span = here;
    return true;
  }
  double v[most_components];
  reader.read(v);
  const auto after = static_cast<std::uint32_t>(reader.offset(run));
  token = literal_token(v, run.width, {here.begin, after - f.pos});
  f.pos = after;
  f.at_comma = after < f.end;
  return true;
}

Token Interpreter::literal_token(const double* v, int width, Span span) {
  ast::Tree& tree = literal_tree_;
  if (tree.exprs.empty()) {
    tree.exprs.resize(slots * exprs_per_slot);
    for (std::uint32_t i = 0; i < slots; ++i) {
      for (std::uint32_t k = 0; k < most_components; ++k) {
        tree.expr_lists.push_back(i * exprs_per_slot + 1 + k);
      }
    }
  }
  literal_slot_ = (literal_slot_ + 1) % slots;
  const std::uint32_t first = literal_slot_ * exprs_per_slot;
  const auto put = [&](std::uint32_t at, auto node) {
    ast::Expr& e = tree.exprs[at];
    e.span = span;
    e.node = node;
  };
  if (width == 1) {
    put(first, ast::Number{v[0]});
  } else {
    const auto count = static_cast<std::uint32_t>(width);
    for (std::uint32_t k = 0; k < count; ++k) put(first + 1 + k, ast::Number{v[k]});
    put(first, ast::Vector{{literal_slot_ * most_components, count}});
  }
  Token token;
  token.kind = Token::Kind::expr;
  token.tree = &tree;
  token.expr = first;
  token.span = span;
  return token;
}

/// True if an element of such a list comes next.
bool Interpreter::at_literals() const {
  if (unread_.size() > unread_base_) return false;
  const Frame& f = frames_.back();
  if (f.kind == Frame::Kind::literals) return !f.at_comma && f.pos < f.end;
  return f.has_items() && f.pos < f.end && f.tree->items[f.pos].kind == ast::ItemKind::literals;
}

/// The list that comes next, if it is one of literals with so many components; null otherwise.
Frame* Interpreter::literals_ahead(int width) {
  if (unread_.size() > unread_base_) return nullptr;
  while (frames_.back().kind == Frame::Kind::literals && frames_.back().pos >= frames_.back().end) {
    pop();
  }
  Frame& f = frames_.back();
  if (f.kind == Frame::Kind::literals) {
    return !f.at_comma && f.tree->literals[f.node].width == width ? &f : nullptr;
  }
  if (!f.has_items() || f.flatten || f.pos >= f.end) return nullptr;
  const ast::Item& item = f.tree->items[f.pos];
  if (item.kind != ast::ItemKind::literals || f.tree->literals[item.ref].width != width) {
    return nullptr;
  }
  ++f.pos;
  push_literals(*f.tree, item);
  return &frames_.back();
}

}  // namespace durer::interpreter
