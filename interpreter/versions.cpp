// What old versions of the language did otherwise (language §4.3, §8.3), and character sets.
#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

/// `declare A = 1`, `include "x.inc"`, `version 2.0`: before 3.0 directives had no `#`.
void Interpreter::obsolete_directive(const Token& word, std::string_view name) {
  warn(Code::deprecated, word.span, fmt::format("`{}` without `#`", name),
       fmt::format("write `#{}`", name));
  if (name == "version") {
    // Nothing after the number may run before it counts.
    const Token t = next();
    if (t.kind != Token::Kind::expr) unexpected(t, "a version number");
    set_version(evaluate(*t.tree, t.expr, 1).v[0], word.span);
    return;
  }
  if (name == "include") {
    const Span at = peek().span;
    include(read_text(true).bytes(), at);
    return;
  }
  ast::Declare node;
  const Token target = peek();
  const Span gap{word.span.end(), target.span.begin - word.span.end()};
  if (target.span.begin > word.span.end()) {
    const std::string_view between = sources_.text(gap);
    const std::size_t mark = between.find_first_not_of(" \t\r\n");
    if (mark != std::string_view::npos && between[mark] == '#') {
      fail(Code::unexpected_item, {static_cast<Loc>(gap.begin + mark), 1},
           "expected a name to declare, found `#`");
    }
  }
  if (const auto* index = target.node<ast::Index>()) {
    next();
    node.name = index->name;
    node.subscripts = index->subscripts;
    node.target = target.span;
  } else {
    node.name = read_name("a name to declare");
    node.target = last_span_;
  }
  const Token equals = next();
  if (!equals.is_punct('=')) unexpected(equals, "`=`");
  try {
    const std::size_t outer = declare_depth_;
    declare_depth_ = frames_.size();
    Value value = read_value();
    declare_depth_ = outer;
    node.semicolon = accept_raw_punct(';');
    if (!node.semicolon && value.is_num()) missing_semicolon(node, *value.get<Num>());
    if (node.subscripts.count == 0) check_may_change(env_.find(node.name), node.target);
    assign(target.tree != nullptr ? *target.tree : *word.tree, node, std::move(value), env_.scope(),
           env_.find(node.name));
  } catch (const Failure&) {
    poison(node.name, 0, true);
    throw;
  }
}

/// What the scene left to the program, in one line.
std::string Interpreter::assumptions() const {
  const scene::Settings& s = scene_.settings;
  const auto gamma = [&]() -> std::string {
    if (s.gamma_mode == scene::GammaMode::off) {
      return "no assumed_gamma, colours are stored as they are";
    }
    if (!assumed_gamma_given_) return native_ ? "assumed_gamma 1 (.scene)" : "assumed_gamma 1 (implied)";
    switch (s.assumed_gamma.kind) {
      case GammaCurve::Kind::linear: return "assumed_gamma 1";
      case GammaCurve::Kind::srgb: return "assumed_gamma srgb";
      case GammaCurve::Kind::power: break;
    }
    return fmt::format("assumed_gamma {:.4g}", s.assumed_gamma.gamma);
  };
  return fmt::format("language {:.2f}{}; {}", s.effective_version / 100.0, version_source_, gamma());
}

namespace {

/// The code that the UTF-8 sequence at `at` stands for; moves `at` to its last byte. None if it is
/// no such sequence.
std::optional<std::uint32_t> utf8_code(std::string_view bytes, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  const unsigned first = byte(at);
  const std::size_t extra = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
  if (extra == 0 || at + extra >= bytes.size()) return std::nullopt;
  std::uint32_t code = first & (0x3FU >> extra);
  for (std::size_t k = 1; k <= extra; ++k) {
    if ((byte(at + k) & 0xC0U) != 0x80) return std::nullopt;
    code = code << 6 | (byte(at + k) & 0x3FU);
  }
  at += extra;
  return code;
}

}  // namespace

/// Bytes above 127 of a literal; `at` ends at the last one taken.
void Interpreter::decode_high_bytes(std::string_view bytes, std::size_t& at, Span span,
                                    Text& out) {
  const auto byte = static_cast<unsigned char>(bytes[at]);
  if (charset_ != Charset::ascii) {
    constexpr char16_t replacement = u'\uFFFD';
    if (const auto code = utf8_code(bytes, at)) {
      out.append(*code > 0xFFFF ? replacement : static_cast<char16_t>(*code));
    } else {
      // The system's own set, if it is not UTF-8, can only be guessed: Latin-1.
      out.append(charset_ == Charset::utf8 ? replacement : static_cast<char16_t>(byte));
    }
    return;
  }
  if (version() < 350) {
    out.append(static_cast<char16_t>(byte));
    return;
  }
  warn(Code::bad_character, span, "characters beyond ASCII become spaces in this string",
       "write `global_settings { charset utf8 }` above");
  out.append(u' ');
}

}  // namespace durer::interpreter
