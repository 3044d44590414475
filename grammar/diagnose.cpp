// From a failure of the grammar to a diagnostic: what was expected, and what stands there instead.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "base/suggest.h"
#include "grammar/builder.h"

namespace durer::grammar {
namespace {

bool is_operator(char c) {
  return std::string_view("+-*/=<>&|!?").find(c) != std::string_view::npos;
}
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// The token that `text` begins with, as far as a message needs it.
std::string_view first_token(std::string_view text) {
  if (text.empty()) return text;
  std::size_t i = 1;
  if (text[0] == '"') {
    while (i < text.size() && text[i] != '"') i += text[i] == '\\' ? 2 : 1;
    i = std::min(i + 1, text.size());
  } else if (is_letter(text[0])) {
    while (i < text.size() && (is_letter(text[i]) || is_digit(text[i]))) ++i;
  } else if (is_digit(text[0])) {
    while (i < text.size() && (is_digit(text[i]) || text[i] == '.')) ++i;
  }
  return text.substr(0, i);
}

std::string describe(std::string_view token, const SymbolTable& symbols) {
  if (token.empty()) return "the end of the file";
  if (token[0] == '"') return "a string";
  const SymbolId id = symbols.find(token);
  const bool reserved = id != SymbolTable::none && symbols.reserved(id);
  return fmt::format("{}`{}`", reserved ? "the reserved word " : "", token);
}

constexpr std::array<std::string_view, 28> directive_words = {
    "break",  "case",    "debug",   "declare", "default", "else",  "elseif",
    "end",    "error",   "fclose",  "fopen",   "for",     "if",    "ifdef",
    "ifndef", "include", "local",   "macro",   "range",   "read",  "render",
    "switch", "undef",   "version", "warning", "while",   "write", "statistics"};

}  // namespace

bool is_directive_in_capitals(std::string_view word) {
  std::string small(word);
  for (char& c : small) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return std::ranges::find(directive_words, small) != directive_words.end();
}

Diagnostic Builder::diagnostic(const Failure& f) const {
  std::string_view rest(f.at, static_cast<std::size_t>(end_ - f.at));
  std::string expected(f.expected);
  // An operator that nothing follows: the trouble is behind it.
  const bool dangling = f.kind == Failure::Kind::expected && !rest.empty() &&
                        is_operator(rest[0]) && f.expected != "`=`";
  if (dangling) {
    expected = fmt::format("an operand after `{}`", rest[0]);
    rest.remove_prefix(1);
    while (!rest.empty() && is_blank(rest[0])) rest.remove_prefix(1);
  }
  const std::string_view token = first_token(rest);
  if (f.kind == Failure::Kind::vector && token == ">") expected = "a component";

  Diagnostic d;
  d.span = span(token.empty() ? std::string_view(end_, 0) : token);
  if (f.opened.begin != 0) d.labels.push_back({f.opened, "opened here"});
  switch (f.kind) {
    case Failure::Kind::nesting:
      d.code = Code::limit;
      d.message = fmt::format("brackets and directives cannot be nested more than {} deep",
                              ast::max_nesting);
      break;
    case Failure::Kind::height:
      d.code = Code::limit;
      d.message =
          fmt::format("an expression cannot be more than {} operators deep", ast::max_height);
      break;
    case Failure::Kind::directive:
      d.message = fmt::format("there is no directive `#{}`", token);
      d.at = "unknown directive";
      if (const auto near = closest(token, directive_words)) {
        d.help.push_back(fmt::format("did you mean `#{}`?", *near));
      }
      break;
    case Failure::Kind::expected:
    case Failure::Kind::vector:
      d.message = fmt::format("expected {}, found {}", expected, describe(token, *symbols_));
      d.at = fmt::format("expected {}", expected);
      if (f.after_operand) d.help.push_back("a comparison needs parentheses here: `(a < b)`");
      break;
  }
  return d;
}

}  // namespace durer::grammar
