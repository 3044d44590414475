// The functions of the language that make strings (language §3.3, §3.5). Each appends its result to
// a text, so that nested calls fill one buffer.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>

#include <fmt/format.h>

#include "base/format_fixed.h"
#include "interpreter/arguments.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

/// `%*.*f` or `%*.*g`, with `%0` for a negative width.
std::string by_library(char conversion, double value, int width, int places) {
  const std::string format = std::string(width < 0 ? "%0*.*" : "%*.*") + conversion;
  std::string line(static_cast<std::size_t>(std::abs(width) + places + 400), '\0');
  const int size = std::snprintf(line.data(), line.size(), format.c_str(), std::abs(width), places, value);
  line.resize(static_cast<std::size_t>(size));
  return line;
}

/// Infinities, and numbers that `format_fixed` has no room for.
std::string unusual_number(double value, int width, int places, std::size_t longest) {
  constexpr int most = 2000;  // no text may be so long: the C library would write two billion blanks
  const int sane_width = std::clamp(width, -most, most);
  const int sane_places = std::min(places, most);
  for (const char conversion : {'f', 'g'}) {
    std::string line = by_library(conversion, value, sane_width, sane_places);
    if (line.size() <= longest) return line;
  }
  return "<invalid>";  // as the oracle says
}

}  // namespace

void append_number(double value, int width, int decimals, Text& out, std::size_t longest) {
  const int places = decimals < 0 ? 6 : decimals;
  const auto wanted = static_cast<std::size_t>(std::abs(std::int64_t{width}));
  constexpr int most_places = 254;  // of format_fixed
  if (places > most_places || wanted > longest || !std::isfinite(value)) {
    return out.append(std::string_view(unusual_number(value, width, places, longest)));
  }
  char digits[format_fixed_size];
  std::string_view number = format_fixed(value, places, digits);
  if (number.size() > longest) {
    return out.append(std::string_view(unusual_number(value, width, places, longest)));
  }
  if (number.size() < wanted) {
    if (width < 0 && number.front() == '-') {
      out.append(u'-');
      number.remove_prefix(1);
    }
    const std::size_t sign = width < 0 && std::signbit(value) ? 1 : 0;
    for (std::size_t i = number.size() + sign; i < wanted; ++i) out.append(width < 0 ? u'0' : u' ');
  }
  out.append(number);
}

void Interpreter::append_text_call(const ast::Tree& tree, const ast::Expr& e, SymbolId function,
                                   std::span<const ast::ExprId> list, const ast::OpenGroup* open,
                                   Text& out) {
  Args args(*this, tree, e, function, list, open);
  const std::size_t first = out.size();
  switch (function) {
    case w::chr: {
      const std::int32_t code = args.integer();
      if (code < 0 || code > 65535) {
        fail(Code::out_of_range, e.span, "`chr` takes codes from 0 to 65535");
      }
      out.append(static_cast<char16_t>(code));
      return args.done();
    }
    case w::concat:
      args.text(out);
      while (args.more()) args.text(out);
      return;
    case w::str: {
      const double x = args.number();
      const int width = args.integer();
      append_number(x, width, args.integer(), out);
      return args.done();
    }
    case w::strlwr:
      args.text(out);
      out.to_lower(first);
      return args.done();
    case w::strupr:
      args.text(out);
      out.to_upper(first);
      return args.done();
    case w::substr: {
      args.text(out);
      const std::size_t size = out.size() - first;
      const int pos = args.integer();
      const int len = args.integer();
      if (pos < 0 || len < 0 || std::int64_t{pos} + len - 1 > static_cast<std::int64_t>(size)) {
        fail(Code::out_of_range, e.span,
             fmt::format("`substr` reaches beyond the string, which has {} characters", size));
      }
      const std::size_t begin = first + static_cast<std::size_t>(std::max(pos, 1) - 1);
      out.erase(std::min(begin + static_cast<std::size_t>(len), out.size()), out.size());
      out.erase(first, std::min(begin, out.size()));
      return args.done();
    }
    case w::vstr: {
      const int n = std::clamp(args.integer(), 2, 5);
      // A float is not replicated here (language §3.3); after `.y` the other slots show (§2.4).
      const Num v = args.any();
      const Text separator = args.text();
      const int width = args.integer();
      const int decimals = args.integer();
      for (int i = 0; i < n; ++i) {
        if (i > 0) out.append(separator);
        append_number(v.v[static_cast<std::size_t>(i)], width, decimals, out, longest_component);
      }
      return args.done();
    }
    case w::datetime: {
      const double days = args.number();
      const std::string format = args.more() ? args.text().bytes() : "%Y-%m-%d %H:%M:%SZ";
      if (format.empty() || format.size() > 200) {
        fail(Code::out_of_range, e.span, "the format of `datetime` must have 1 to 200 characters");
      }
      const auto seconds = static_cast<std::time_t>(std::llround((days + 10957) * 86400));
      std::tm parts{};
      gmtime_r(&seconds, &parts);
      char buffer[512];
      const std::size_t n = std::strftime(buffer, sizeof buffer, format.c_str(), &parts);
      if (n == 0) fail(Code::evaluation, e.span, "the result of `datetime` is too long");
      out.append(std::string_view(buffer, n));
      return args.done();
    }
    default: break;
  }
  fail(Code::wrong_kind, e.span, fmt::format("`{}` does not make a string", name_of(function)));
}

}  // namespace durer::interpreter
