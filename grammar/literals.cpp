#include "grammar/literals.h"

#include <algorithm>
#include <charconv>

namespace durer::grammar {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r') || c == '\x1A' || c == '\0';
}

const char* skip_blanks(const char* at, const char* end) {
  while (at != end && is_blank(*at)) ++at;
  return at;
}
const char* skip_digits(const char* at, const char* end) {
  while (at != end && is_digit(*at)) ++at;
  return at;
}

/// The end of the number at `at`, which may have a minus; null if there is none, or one that only
/// looks like it (`1e`, `1.5.x`).
const char* end_of_number(const char* at, const char* end) {
  if (at != end && *at == '-') at = skip_blanks(at + 1, end);
  const char* const first = at;
  at = skip_digits(at, end);
  bool digits = at != first;
  if (at != end && *at == '.') {
    const char* const point = at + 1;
    at = skip_digits(point, end);
    digits = digits || at != point;
  }
  if (!digits) return nullptr;
  if (at != end && (*at == 'e' || *at == 'E')) {
    ++at;
    if (at != end && (*at == '-' || *at == '+')) ++at;
    const char* const exponent = at;
    at = skip_digits(at, end);
    if (at == exponent) return nullptr;
  }
  return at;
}

/// The end of the element at `at`, and its width; null if it is no literal.
const char* end_of_element(const char* at, const char* end, int& width) {
  if (*at != '<') {
    width = 1;
    return end_of_number(at, end);
  }
  width = 0;
  do {
    at = end_of_number(skip_blanks(at + 1, end), end);
    if (at == nullptr || ++width > 5) return nullptr;
    at = skip_blanks(at, end);
  } while (at != end && *at == ',');
  return at != end && *at == '>' && width > 1 ? at + 1 : nullptr;
}

/// Powers of ten that a double holds exactly.
constexpr double exact_powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                   1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                   1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// The number at `at`, which end_of_number has accepted. Up to 2^53 over a power of ten, both exact,
/// the quotient is correctly rounded (Clinger, "How to read floating point numbers accurately").
double read_number(const char*& at, const char* end) {
  const bool negative = *at == '-';
  if (negative) at = skip_blanks(at + 1, end);
  const char* const first = at;
  std::uint64_t mantissa = 0;
  for (; at != end && is_digit(*at); ++at) {
    mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
  }
  std::size_t digits = static_cast<std::size_t>(at - first);
  std::size_t decimals = 0;
  if (at != end && *at == '.') {
    const char* const point = ++at;
    for (; at != end && is_digit(*at); ++at) {
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
    }
    decimals = static_cast<std::size_t>(at - point);
    digits += decimals;
  }
  constexpr std::uint64_t largest_exact = std::uint64_t{1} << 53;
  double x = 0;
  if ((at == end || (*at != 'e' && *at != 'E')) && digits <= 19 && mantissa <= largest_exact &&
      decimals <= 22) {
    x = static_cast<double>(mantissa) / exact_powers[decimals];
  } else {
    at = std::from_chars(first, end, x).ptr;
  }
  return negative ? -x : x;
}

}  // namespace

LiteralRun find_literals(const char* from, const char* end, std::uint32_t shortest,
                         const char*& stopped) {
  LiteralRun run;
  const char* last = from;
  for (const char* at = from; at != end;) {
    int width = 0;
    const char* const after = end_of_element(at, end, width);
    if (after == nullptr || (run.count > 0 && width != run.width)) break;
    const char* const next = skip_blanks(after, end);
    if (next == end || (*next != ',' && *next != '}')) break;
    run.width = static_cast<std::uint8_t>(width);
    run.comma_after = *next == ',';
    ++run.count;
    last = run.comma_after ? next + 1 : after;
    if (!run.comma_after) break;
    at = skip_blanks(next + 1, end);
  }
  stopped = last;
  run.text = std::string_view(from, static_cast<std::size_t>(last - from));
  if (run.count < shortest) run = {};
  return run;
}

const LiteralRun* LiteralRuns::find(const char* begin, const char* at, const char* end) {
  if (at < none_before_) return nullptr;
  const char* before = at;
  while (before != begin && is_blank(before[-1])) --before;
  if (before == begin || (before[-1] != ',' && before[-1] != '{')) return nullptr;
  const LiteralRun run = find_literals(at, end, shortest, none_before_);
  if (run.count == 0) return nullptr;
  runs_.push_back(run);
  return &runs_.back();
}

const LiteralRun* LiteralRuns::at(const char* at) const {
  if (runs_.empty()) return nullptr;
  const auto found = std::lower_bound(
      runs_.begin(), runs_.end(), at,
      [](const LiteralRun& run, const char* place) { return run.text.data() < place; });
  return found != runs_.end() && found->text.data() == at ? &*found : nullptr;
}

void LiteralReader::read(double* v) {
  at_ = skip_blanks(at_, end_);
  if (*at_ != '<') {
    v[0] = read_number(at_, end_);
    at_ = skip_blanks(at_, end_);
    return;
  }
  for (int i = 0; i < width_; ++i) {
    at_ = skip_blanks(at_ + 1, end_);  // behind the `<` or `,`
    v[i] = read_number(at_, end_);
    at_ = skip_blanks(at_, end_);
  }
  at_ = skip_blanks(at_ + 1, end_);
}

bool LiteralReader::comma() {
  if (at_ == end_ || *at_ != ',') return false;
  at_ = skip_blanks(at_ + 1, end_);
  return true;
}

}  // namespace durer::grammar
