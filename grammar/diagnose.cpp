// From a failure of the grammar to a diagnostic: what was expected, and what stands there instead.
#include <fmt/format.h>

#include "grammar/builder.h"

namespace durer::grammar {
namespace {

bool is_operator(char c) { return std::string_view("+-*/=<>&|!?").find(c) != std::string_view::npos; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The token at `at`, as far as a message needs it.
std::size_t token_size(std::string_view text) {
  if (text.empty()) return 0;
  if (text[0] == '"') {
    std::size_t i = 1;
    while (i < text.size() && text[i] != '"') i += text[i] == '\\' ? 2 : 1;
    return std::min(i + 1, text.size());
  }
  std::size_t i = 1;
  if (is_digit(text[0])) {
    while (i < text.size() && (is_digit(text[i]) || text[i] == '.')) ++i;
  }
  return i;
}

}  // namespace

Diagnostic Builder::diagnostic(const Failure& f) const {
  const char* at = f.at;
  std::string expected(f.expected);
  // An operator that nothing follows: the trouble is behind it.
  if (f.code == Code::syntax && at != end_ && is_operator(*at) && f.expected != "`=`") {
    expected = fmt::format("an operand after `{}`", *at);
    ++at;
    while (at != end_ && (*at == ' ' || (*at >= '\t' && *at <= '\r'))) ++at;
  }
  const std::string_view rest(at, static_cast<std::size_t>(end_ - at));
  Builder& self = const_cast<Builder&>(*this);
  const Word* word = self.word_at(at, end_);
  const std::size_t size = word != nullptr ? static_cast<std::size_t>(word->end - word->begin)
                                           : token_size(rest);
  std::string found = rest.empty() ? "the end of the file" : fmt::format("`{}`", rest.substr(0, size));
  if (!rest.empty() && rest[0] == '"') found = "a string";
  if (word != nullptr && symbols_->reserved(word->id)) found = "the reserved word " + found;

  Diagnostic d;
  d.code = f.code;
  d.span = {base_ + offset(at), static_cast<std::uint32_t>(size)};
  if (f.code == Code::limit) {
    d.message = f.expected == "fewer operators"
                    ? fmt::format("an expression may be {} operators deep", ast::max_height)
                    : fmt::format("brackets and directives may be nested {} deep", ast::max_nesting);
    d.at = fmt::format("expected {}", expected);
    return d;
  }
  d.message = fmt::format("expected {}, found {}", expected, found);
  d.at = fmt::format("expected {}", expected);
  if (f.opened.begin != 0) d.labels.push_back({f.opened, "opened here"});
  return d;
}

}  // namespace durer::grammar
