#include "interpreter/data_file.h"

#include <cctype>
#include <cstdlib>

namespace durer::interpreter {

DataFile::DataFile(const std::string& path, Mode mode) : path_(path), mode_(mode) {
  const auto binary = std::ios::binary;
  stream_.open(path, mode == Mode::read    ? std::ios::in | binary
                     : mode == Mode::write ? std::ios::out | std::ios::trunc | binary
                                           : std::ios::out | std::ios::app | binary);
}

/// The next byte that is neither white space nor part of a comment, taken; EOF at the end.
int DataFile::skip_blank() {
  for (;;) {
    int c = stream_.get();
    if (c != EOF && std::isspace(c) != 0) continue;
    if (c == '/' && stream_.peek() == '/') {
      while (c != EOF && c != '\n') c = stream_.get();
      continue;
    }
    if (c == '/' && stream_.peek() == '*') {
      int depth = 1;
      stream_.get();
      while (depth > 0 && (c = stream_.get()) != EOF) {
        if (c == '*' && stream_.peek() == '/') {
          stream_.get();
          --depth;
        } else if (c == '/' && stream_.peek() == '*') {
          stream_.get();
          ++depth;
        }
      }
      continue;
    }
    return c;
  }
}

std::optional<double> DataFile::number(int c) {
  std::string text;
  if (c == '-' || c == '+') {
    if (c == '-') text += '-';
    c = skip_blank();
  }
  bool digits = false;
  while (c != EOF && (std::isalnum(c) != 0 || c == '.' ||
                      ((c == '+' || c == '-') && !text.empty() &&
                       (text.back() == 'e' || text.back() == 'E')))) {
    digits |= std::isdigit(c) != 0;
    text += static_cast<char>(c);
    c = stream_.get();
  }
  if (c != EOF) stream_.unget();
  stream_.clear(stream_.rdstate() & ~std::ios::failbit);
  if (!digits) return std::nullopt;
  return std::strtod(text.c_str(), nullptr);
}

DataFile::Datum DataFile::read() {
  const auto look_ahead = [&] {
    const int c = skip_blank();
    if (c == EOF) {
      at_end_ = true;
    } else if (c != ',') {
      // Anything but a comma is lost, as a whole token.
      if (std::isdigit(c) != 0 || c == '.') {
        number(c);
      } else if (c == '"') {
        for (int d = stream_.get(); d != EOF && d != '"'; d = stream_.get()) {
        }
      }
    }
  };
  const int c = skip_blank();
  if (c == EOF) {
    at_end_ = true;
    return End{};
  }
  if (c == '"') {
    std::string text;
    for (int d = stream_.get(); d != '"'; d = stream_.get()) {
      if (d == EOF) return Bad{"a string that does not end"};
      text += static_cast<char>(d);
      if (d == '\\') {
        if (const int e = stream_.get(); e != EOF) text += static_cast<char>(e);
      }
    }
    look_ahead();
    return text;
  }
  if (c == '<') {
    Num n;
    n.length = 0;
    for (int d = skip_blank(); d != '>'; d = skip_blank()) {
      if (d == ',') continue;
      const auto x = d == EOF ? std::nullopt : number(d);
      if (!x || n.length == 5) return Bad{"expected a vector of 2 to 5 numbers"};
      n.v[static_cast<std::size_t>(n.length++)] = *x;
    }
    look_ahead();
    return n;
  }
  const auto x = number(c);
  if (!x)
    return Bad{std::string("expected a number, vector or string, found `") + static_cast<char>(c) +
               "`"};
  look_ahead();
  return Num(*x);
}

}  // namespace durer::interpreter
