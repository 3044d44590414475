// The tree as canonical text. Parsing that text gives an equal tree: tokens are separated by
// blanks, every item of a file, block or body stands on a line of its own, numbers round-trip.
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "grammar/parse.h"

namespace durer::grammar {
namespace {

std::string_view op_text(ast::Op op) {
  switch (op) {
    case ast::Op::add:
    case ast::Op::pos: return "+";
    case ast::Op::sub:
    case ast::Op::neg: return "-";
    case ast::Op::mul: return "*";
    case ast::Op::div: return "/";
    case ast::Op::lt: return "<";
    case ast::Op::le: return "<=";
    case ast::Op::eq: return "=";
    case ast::Op::ne: return "!=";
    case ast::Op::ge: return ">=";
    case ast::Op::gt: return ">";
    case ast::Op::and_: return "&";
    case ast::Op::or_: return "|";
    case ast::Op::not_: return "!";
  }
  return "";
}

// Numbers have no sign, and infinity is only written as one too large.
std::string number_text(double value) {
  if (std::isinf(value)) return "1e999";
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string string_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '\\';
    out += c;
  }
  return out + '"';
}

class Printer {
 public:
  Printer(const ast::Tree& tree, const SymbolTable& symbols) : tree_(tree), symbols_(symbols) {}

  std::string run() {
    lines(tree_.top);
    // The mark that makes strings UTF-8 (language §1.1).
    return tree_.utf8 ? "\xEF\xBB\xBF" + out_ : out_;
  }

 private:
  // ---- expressions -----------------------------------------------------------------------------

  void expr(ast::ExprId id) {
    std::visit([this](const auto& node) { write(node); }, tree_.exprs[id].node);
  }
  void name(SymbolId id) { out_ += symbols_.text(id); }

  void list(ast::Range range, std::string_view separator) {
    for (std::uint32_t i = 0; i < range.count; ++i) {
      if (i > 0) out_ += separator;
      expr(tree_.expr_lists[range.first + i]);
    }
  }

  void write(const ast::Number& n) { out_ += number_text(n.value); }
  void write(const ast::String& s) { out_ += string_text(tree_.strings[s.index]); }
  void write(const ast::Name& n) { name(n.name); }
  void write(const ast::Paren& p) {
    out_ += '(';
    expr(p.inner);
    out_ += ')';
  }
  void write(const ast::Vector& v) {
    out_ += '<';
    list(v.components, ", ");
    out_ += '>';
  }
  void write(const ast::Unary& u) {
    out_ += op_text(u.op);
    expr(u.operand);
  }
  void write(const ast::Binary& b) {
    expr(b.left);
    out_ += ' ';
    out_ += op_text(b.op);
    out_ += ' ';
    expr(b.right);
  }
  void write(const ast::Conditional& c) {
    expr(c.condition);
    out_ += " ? ";
    expr(c.yes);
    out_ += " : ";
    expr(c.no);
  }
  void write(const ast::Call& c) {
    expr(c.callee);
    out_ += '(';
    list(c.args, ", ");
    out_ += ')';
  }
  void write(const ast::Index& i) {
    name(i.name);
    subscripts(i.subscripts);
  }
  void subscripts(ast::Range range) {
    for (std::uint32_t i = 0; i < range.count; ++i) {
      out_ += '[';
      expr(tree_.expr_lists[range.first + i]);
      out_ += ']';
    }
  }
  void write(const ast::Member& m) {
    expr(m.object);
    // `3.x` would be the number 3. and a name.
    if (std::holds_alternative<ast::Number>(tree_.exprs[m.object].node)) out_ += ' ';
    out_ += '.';
    name(m.member);
  }
  void write(const ast::Element& e) {
    expr(e.object);
    subscripts(e.subscripts);
  }
  void write(const ast::OpenGroup& g) {
    using Kind = ast::OpenGroup::Kind;
    if (g.kind == Kind::call) expr(g.callee);
    if (g.kind == Kind::index) name(g.name);
    if (g.kind == Kind::index) return words(g.items);
    out_ += g.kind == Kind::vector ? '<' : '(';
    lines(g.items);
    out_ += g.kind == Kind::vector ? '>' : ')';
  }

  // ---- items -----------------------------------------------------------------------------------

  void lines(ast::Range range) { items(range, '\n'); }
  void words(ast::Range range) { items(range, ' '); }
  void items(ast::Range range, char separator) {
    for (std::uint32_t i = 0; i < range.count; ++i) {
      item(tree_.items[range.first + i], separator);
      out_ += separator;
    }
  }

  /// As if each element were an item: where a list is cut into runs does not show.
  void literals(const LiteralRun& run, char separator) {
    LiteralReader reader(run);
    for (std::uint32_t i = 0; i < run.count; ++i) {
      double v[5];
      reader.read(v);
      if (i > 0) out_ += separator;
      if (run.width > 1) out_ += '<';
      for (int k = 0; k < run.width; ++k) {
        if (k > 0) out_ += ", ";
        if (std::signbit(v[k])) out_ += '-';
        out_ += number_text(std::abs(v[k]));
      }
      if (run.width > 1) out_ += '>';
      if (!reader.comma()) continue;
      out_ += separator;
      mark(',');
    }
  }

  void item(const ast::Item& i, char separator) {
    switch (i.kind) {
      case ast::ItemKind::expr: return expr(i.ref);
      case ast::ItemKind::word: return name(i.ref);
      case ast::ItemKind::braces: return group(tree_.groups[i.ref], '{', '}');
      case ast::ItemKind::brackets: return group(tree_.groups[i.ref], '[', ']');
      case ast::ItemKind::directive:
        return std::visit([this](const auto& node) { write(node); }, tree_.directives[i.ref].node);
      case ast::ItemKind::literals: return literals(tree_.literals[i.ref], separator);
      case ast::ItemKind::punct: return mark(i.detail);
    }
  }

  void group(const ast::Group& g, char open, char close) {
    out_ += open;
    lines(g.items);
    out_ += close;
  }

  void mark(char detail) {
    switch (detail) {
      case 'l': out_ += "<="; break;
      case 'g': out_ += ">="; break;
      case 'n': out_ += "!="; break;
      default: out_ += detail;
    }
  }

  // ---- directives ------------------------------------------------------------------------------

  void operand(std::string_view head, ast::ExprId value) {
    out_ += head;
    if (value == ast::none) return;
    out_ += ' ';
    expr(value);
  }
  void end() { out_ += "#end"; }

  void write(const ast::Declare& d) {
    out_ += d.local ? "#local " : "#declare ";
    if (d.deprecated) out_ += "deprecated ";
    if (d.deprecated_once) out_ += "once ";
    if (d.deprecated_message != ast::none) operand("", d.deprecated_message);
    out_ += ' ';
    target(d.name, d.subscripts, d.place);
    operand(" =", d.value);
    if (d.semicolon) out_ += ';';
  }
  void target(SymbolId symbol, ast::Range list, ast::ExprId place) {
    if (place != ast::none) return expr(place);
    name(symbol);
    subscripts(list);
  }
  void write(const ast::Undef& u) {
    out_ += "#undef ";
    target(u.name, u.subscripts, u.place);
  }
  void write(const ast::Tuple& t) {
    out_ += t.local ? "#local " : "#declare ";
    out_ += t.kind;
    for (std::uint32_t i = 0; i < t.targets.count; ++i) {
      if (i > 0) out_ += ", ";
      const ast::ExprId id = tree_.expr_lists[t.targets.first + i];
      if (id != ast::none) expr(id);
    }
    out_ += t.kind == '(' ? ") =" : t.kind == '<' ? "> =" : "} =";
  }
  void write(const ast::If& n) {
    for (std::uint32_t i = 0; i < n.branches.count; ++i) {
      const ast::Branch& branch = tree_.branches[n.branches.first + i];
      branch_head(branch, i == 0);
      lines(branch.items);
    }
    end();
  }
  void branch_head(const ast::Branch& branch, bool first) {
    switch (branch.kind) {
      case ast::Branch::Kind::if_: operand(first ? "#if" : "#elseif", branch.condition); break;
      case ast::Branch::Kind::ifdef:
      case ast::Branch::Kind::ifndef:
        out_ += branch.kind == ast::Branch::Kind::ifdef ? "#ifdef (" : "#ifndef (";
        expr(branch.condition);
        out_ += ')';
        break;
      case ast::Branch::Kind::else_: out_ += "#else"; break;
    }
    out_ += '\n';
  }
  void write(const ast::Switch& s) {
    operand("#switch", s.value);
    out_ += '\n';
    for (std::uint32_t i = 0; i < s.cases.count; ++i) {
      const ast::Case& c = tree_.cases[s.cases.first + i];
      case_head(c);
      lines(c.items);
    }
    end();
  }
  void case_head(const ast::Case& c) {
    switch (c.kind) {
      case ast::Case::Kind::case_: operand("#case", c.low); break;
      case ast::Case::Kind::range:
        out_ += "#range (";
        expr(c.low);
        out_ += ", ";
        expr(c.high);
        out_ += ')';
        break;
      case ast::Case::Kind::else_: out_ += "#else"; break;
    }
    out_ += '\n';
  }
  void write(const ast::While& w) {
    operand("#while", w.condition);
    out_ += '\n';
    lines(w.items);
    end();
  }
  void write(const ast::For& f) {
    out_ += "#for (";
    name(f.name);
    operand(",", f.start);
    operand(",", f.end);
    if (f.step != ast::none) operand(",", f.step);
    out_ += ")\n";
    lines(f.items);
    end();
  }
  void write(const ast::Macro& m) {
    out_ += "#macro ";
    name(m.name);
    out_ += '(';
    for (std::uint32_t i = 0; i < m.params.count; ++i) {
      if (i > 0) out_ += ", ";
      if (tree_.params[m.params.first + i].optional) out_ += "optional ";
      name(tree_.params[m.params.first + i].name);
    }
    out_ += ")\n";
    lines(m.items);
    end();
  }
  void write(const ast::Break&) { out_ += "#break"; }
  void write(const ast::Include& i) { operand("#include", i.value); }
  void write(const ast::Version& v) {
    operand("#version", v.value);
    if (v.value != ast::none) out_ += ';';
  }
  void write(const ast::Message& m) {
    using Kind = ast::Message::Kind;
    switch (m.kind) {
      case Kind::debug: return operand("#debug", m.value);
      case Kind::warning: return operand("#warning", m.value);
      case Kind::error: return operand("#error", m.value);
      case Kind::render: return operand("#render", m.value);
      case Kind::statistics: return operand("#statistics", m.value);
    }
  }
  void write(const ast::Simple& s) {
    using Kind = ast::Simple::Kind;
    switch (s.kind) {
      case Kind::default_: out_ += "#default"; break;
      case Kind::fopen: out_ += "#fopen"; break;
      case Kind::fclose: out_ += "#fclose"; break;
      case Kind::read: out_ += "#read"; break;
      case Kind::write: out_ += "#write"; break;
    }
  }
  void write(const ast::Unknown& u) {
    out_ += '#';
    name(u.word);
    if (opens_body(u.word)) out_ += " #end";  // what was in it is not in the tree
  }
  static bool opens_body(SymbolId word) {
    switch (word) {
      case words::if_:
      case words::ifdef:
      case words::ifndef:
      case words::while_:
      case words::for_:
      case words::switch_:
      case words::macro: return true;
      default: return false;
    }
  }

  const ast::Tree& tree_;
  const SymbolTable& symbols_;
  std::string out_;
};

}  // namespace

std::string print(const ast::Tree& tree, const SymbolTable& symbols) {
  return Printer(tree, symbols).run();
}

}  // namespace durer::grammar
