#include "tests/unit/grammar/dump.h"

#include <fmt/format.h>

namespace durer::test {
namespace {

constexpr std::string_view op_names[] = {
    "+", "-", "*", "/", "<", "<=", "=", "!=", ">=", ">", "&", "|", "neg", "pos", "!"};

class Dumper {
 public:
  Dumper(const ast::Tree& tree, const grammar::SymbolTable& symbols) : t_(tree), s_(symbols) {}

  std::string items(ast::Range range) const {
    std::string out;
    for (std::uint32_t i = 0; i < range.count; ++i) {
      if (i > 0) out += ' ';
      out += item(t_.items[range.first + i]);
    }
    return out;
  }

 private:
  std::string name(grammar::SymbolId id) const { return std::string(s_.text(id)); }
  std::string expr(ast::ExprId id) const {
    if (id == ast::none) return "none";
    return std::visit([this](const auto& n) { return show(n); }, t_.exprs[id].node);
  }
  std::string list(ast::Range range, std::string_view before, std::string_view after) const {
    std::string out;
    for (std::uint32_t i = 0; i < range.count; ++i) {
      out += fmt::format("{}{}{}", before, expr(t_.expr_lists[range.first + i]), after);
    }
    return out;
  }

  std::string show(const ast::Number& n) const { return fmt::format("{:g}", n.value); }
  std::string show(const ast::String& n) const {
    return fmt::format("\"{}\"", t_.strings[n.index]);
  }
  std::string show(const ast::Name& n) const { return name(n.name); }
  std::string show(const ast::Paren& n) const { return fmt::format("({})", expr(n.inner)); }
  std::string show(const ast::Vector& n) const {
    return fmt::format("<{}>", list(n.components, " ", "").substr(1));
  }
  std::string show(const ast::Unary& n) const {
    return fmt::format("({} {})", op_names[static_cast<int>(n.op)], expr(n.operand));
  }
  std::string show(const ast::Binary& n) const {
    return fmt::format("({} {} {})", op_names[static_cast<int>(n.op)], expr(n.left), expr(n.right));
  }
  std::string show(const ast::Conditional& n) const {
    return fmt::format("(? {} {} {})", expr(n.condition), expr(n.yes), expr(n.no));
  }
  std::string show(const ast::Call& n) const {
    return fmt::format("{}({})", expr(n.callee),
                       n.args.count == 0 ? "" : list(n.args, " ", "").substr(1));
  }
  std::string show(const ast::Index& n) const {
    return name(n.name) + list(n.subscripts, "[", "]");
  }
  std::string show(const ast::Member& n) const {
    return fmt::format("{}.{}", expr(n.object), name(n.member));
  }
  std::string show(const ast::Element& n) const {
    return expr(n.object) + list(n.subscripts, "[", "]");
  }
  std::string show(const ast::OpenGroup& n) const {
    switch (n.kind) {
      case ast::OpenGroup::Kind::paren: return fmt::format("open({})", items(n.items));
      case ast::OpenGroup::Kind::vector: return fmt::format("open<{}>", items(n.items));
      case ast::OpenGroup::Kind::call:
        return fmt::format("open {}({})", expr(n.callee), items(n.items));
      case ast::OpenGroup::Kind::index:
        return fmt::format("open {}{}", name(n.name), items(n.items));
    }
    return {};
  }

  std::string item(const ast::Item& i) const {
    switch (i.kind) {
      case ast::ItemKind::expr: return expr(i.ref);
      case ast::ItemKind::word: return fmt::format(":{}", name(i.ref));
      case ast::ItemKind::braces: return fmt::format("{{{}}}", items(t_.groups[i.ref].items));
      case ast::ItemKind::brackets: return fmt::format("[{}]", items(t_.groups[i.ref].items));
      case ast::ItemKind::literals: return fmt::format("literals({})", t_.literals[i.ref].text);
      case ast::ItemKind::punct: return fmt::format("'{}'", i.detail);
      case ast::ItemKind::directive:
        return std::visit([this](const auto& n) { return show(n); }, t_.directives[i.ref].node);
    }
    return {};
  }

  std::string show(const ast::Declare& n) const {
    std::string out = n.local ? "#local " : "#declare ";
    if (n.deprecated) out += n.deprecated_once ? "(deprecated once " : "(deprecated ";
    if (n.deprecated) out += expr(n.deprecated_message) + ") ";
    out += target(n.name, n.subscripts, n.place) + '=' + expr(n.value);
    return n.semicolon ? out + ';' : out;
  }
  std::string show(const ast::Undef& n) const {
    return "#undef " + target(n.name, n.subscripts, n.place);
  }
  std::string target(grammar::SymbolId symbol, ast::Range subscripts, ast::ExprId place) const {
    return place != ast::none ? expr(place) : name(symbol) + list(subscripts, "[", "]");
  }
  std::string show(const ast::Tuple& n) const {
    return fmt::format("#{} {}{}=", n.local ? "local" : "declare", n.kind, (n.targets.count == 0 ? "" : list(n.targets, " ", "").substr(1)));
  }
  std::string show(const ast::If& n) const {
    constexpr std::string_view kinds[] = {"if", "ifdef", "ifndef", "else"};
    std::string out = "#";
    for (std::uint32_t i = 0; i < n.branches.count; ++i) {
      const ast::Branch& b = t_.branches[n.branches.first + i];
      out += fmt::format("{}{} {}{{{}}}", i > 0 ? " " : "", kinds[static_cast<int>(b.kind)],
                         b.condition == ast::none ? "" : expr(b.condition), items(b.items));
    }
    return out;
  }
  std::string show(const ast::While& n) const {
    return fmt::format("#while {}{{{}}}", expr(n.condition), items(n.items));
  }
  std::string show(const ast::For& n) const {
    return fmt::format("#for {} {} {} {}{{{}}}", name(n.name), expr(n.start), expr(n.end),
                       expr(n.step), items(n.items));
  }
  std::string show(const ast::Switch& n) const {
    std::string out = "#switch " + expr(n.value);
    for (std::uint32_t i = 0; i < n.cases.count; ++i) {
      const ast::Case& c = t_.cases[n.cases.first + i];
      switch (c.kind) {
        case ast::Case::Kind::case_: out += " case " + expr(c.low); break;
        case ast::Case::Kind::range: out += " range " + expr(c.low) + ' ' + expr(c.high); break;
        case ast::Case::Kind::else_: out += " else"; break;
      }
      out += fmt::format("{{{}}}", items(c.items));
    }
    return out;
  }
  std::string show(const ast::Macro& n) const {
    std::string params;
    for (std::uint32_t i = 0; i < n.params.count; ++i) {
      if (i > 0) params += ' ';
      const ast::Param& param = t_.params[n.params.first + i];
      params += (param.optional ? "optional " : "") + name(param.name);
    }
    return fmt::format("#macro {}({}){{{}}}", name(n.name), params, items(n.items));
  }
  std::string show(const ast::Break&) const { return "#break"; }
  std::string show(const ast::Include& n) const { return "#include " + expr(n.value); }
  std::string show(const ast::Version& n) const { return "#version " + expr(n.value); }
  std::string show(const ast::Message& n) const {
    constexpr std::string_view kinds[] = {"debug", "warning", "error", "render", "statistics"};
    return fmt::format("#{} {}", kinds[static_cast<int>(n.kind)], expr(n.value));
  }
  std::string show(const ast::Simple& n) const {
    constexpr std::string_view kinds[] = {"default", "fopen", "fclose", "read", "write"};
    return fmt::format("#{}", kinds[static_cast<int>(n.kind)]);
  }
  std::string show(const ast::Unknown& n) const { return "#unknown " + name(n.word); }

  const ast::Tree& t_;
  const grammar::SymbolTable& s_;
};

std::string summary(const Diagnostic& d, const SourceMap& sources) {
  const Place place = sources.place(d.span.begin);
  return fmt::format("{} {}:{} {}", code_text(d.code), place.line, place.column, d.message);
}

}  // namespace

Parsed::Parsed(std::string_view source) {
  const FileId file = sources.add("test.pov", std::string(source));
  tree = grammar::parse(sources, file, symbols, diagnostics);
}

std::string Parsed::items(ast::Range range) const { return Dumper(*tree, symbols).items(range); }

std::string dump(std::string_view source) {
  const Parsed parsed(source);
  return parsed.tree == nullptr ? summary(parsed.diagnostics.all().front(), parsed.sources)
                                : parsed.items(parsed.tree->top);
}

std::string diagnose(std::string_view source) {
  const Parsed parsed(source);
  if (parsed.diagnostics.all().empty()) return "none";
  return summary(parsed.diagnostics.all().front(), parsed.sources);
}

}  // namespace durer::test
