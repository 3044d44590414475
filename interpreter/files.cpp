// #fopen, #fclose, #read, #write (language §4.11).
#include <cmath>

#include <fmt/format.h>
#include <fmt/printf.h>

#include "interpreter/data_file.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

/// The name that the next token is, declared or not.
SymbolId Interpreter::read_name(std::string_view what) {
  const Token t = next();
  if (const auto* name = t.node<ast::Name>(); name != nullptr && !symbols_.reserved(name->name)) {
    last_span_ = t.span;
    return name->name;
  }
  unexpected(t, what);
}

DataFile& Interpreter::file_named(SymbolId name, Span span) {
  const Value* v = Environment::value_of(env_.find(name));
  if (v == nullptr) unknown_name(name, span);
  const auto* file = v->get<std::shared_ptr<DataFile>>();
  if (file == nullptr) {
    fail(Code::wrong_kind, span,
         fmt::format("`{}` is {}, not an open file", name_of(name), kind_name(*v)));
  }
  return **file;
}

void Interpreter::open_file(Span span) {
  const SymbolId name = read_name("a name for the file");
  if (env_.find(name) != nullptr) {
    fail(Code::evaluation, last_span_, fmt::format("`{}` is already in use", name_of(name)),
         "close it with `#fclose`, or choose another name");
  }
  const std::string path = read_text(true).bytes();
  const Token mode = next();
  std::shared_ptr<DataFile> file;
  if (mode.is(w::read)) {
    const auto found = find_file(path, span);
    if (!found) missing_file(path, span);
    file = std::make_shared<DataFile>(*found, DataFile::Mode::read);
  } else if (mode.is(w::write) || mode.is(w::append)) {
    check_writable(path, span);
    forget_text(path);
    file = std::make_shared<DataFile>(
        path, mode.is(w::write) ? DataFile::Mode::write : DataFile::Mode::append);
  } else {
    unexpected(mode, "`read`, `write` or `append`");
  }
  if (!file->good())
    fail(Code::file_not_found, span, fmt::format("cannot open the file `{}`", path));
  env_.for_global(name).value = Value(std::move(file));
}

void Interpreter::close_file() {
  const SymbolId name = read_name("the name of an open file");
  const Value* v = Environment::value_of(env_.find(name));
  if (v != nullptr && v->get<std::shared_ptr<DataFile>>() != nullptr) env_.undefine(name);
}

/// Runs `body` on the tokens between the parentheses that come next, balanced or not.
template <typename Body>
void Interpreter::in_parentheses(std::string_view what, Body body) {
  const Token t = next();
  if (t.is_punct('(')) {
    body([&] { return peek().is_punct(')') || peek().kind == Token::Kind::end; });
    const Token close = next();
    if (!close.is_punct(')')) unexpected(close, "`)`");
    return;
  }
  const auto at_end = [&] { return peek().kind == Token::Kind::end; };
  if (const auto* p = t.node<ast::Paren>()) {
    const Nested part(*this, *t.tree, p->inner);
    body(at_end);
  } else if (const auto* g = t.node<ast::OpenGroup>();
             g != nullptr && g->kind == ast::OpenGroup::Kind::paren) {
    const Nested part(*this, *t.tree, g->items);
    body(at_end);
  } else {
    unexpected(t, fmt::format("`(` after `#{}`", what));
  }
}

namespace {

struct BinaryFormat {
  int bytes = 0;  // 0: text
  bool is_signed = false;
  bool big_endian = false;
};

BinaryFormat format_of(SymbolId word) {
  switch (word) {
    case w::sint8: return {1, true, false};
    case w::uint8: return {1, false, false};
    case w::sint16be: return {2, true, true};
    case w::sint16le: return {2, true, false};
    case w::uint16be: return {2, false, true};
    case w::uint16le: return {2, false, false};
    case w::sint32be: return {4, true, true};
    case w::sint32le: return {4, true, false};
    default: return {};
  }
}

std::string as_text(const Num& n) {
  if (n.length == 1) return fmt::sprintf("%g", n.v[0]);
  std::string s = "<";
  for (int i = 0; i < n.length; ++i) {
    s += fmt::sprintf(i == 0 ? "%g" : ",%g", n.v[static_cast<std::size_t>(i)]);
  }
  return s + "> ";
}

std::string as_bytes(const Num& n, BinaryFormat f) {
  std::string s;
  const double top = std::exp2(8 * f.bytes - (f.is_signed ? 1 : 0)) - 1;
  const double bottom = f.is_signed ? -top - 1 : 0;
  for (int i = 0; i < n.length; ++i) {
    const double v = std::clamp(std::floor(n.v[static_cast<std::size_t>(i)] + 0.5), bottom, top);
    const auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(v));
    for (int k = 0; k < f.bytes; ++k) {
      const int shift = 8 * (f.big_endian ? f.bytes - 1 - k : k);
      s += static_cast<char>(bits >> shift & 0xFF);
    }
  }
  return s;
}

}  // namespace

void Interpreter::write_file() {
  // `#write (File (A), …)` is no call, but a name and the first values.
  const auto read_file_name = [&] {
    const Token t = peek();
    const auto* call = t.node<ast::Call>();
    const auto* name =
        call == nullptr ? nullptr : std::get_if<ast::Name>(&t.tree->exprs[call->callee].node);
    if (name == nullptr) return read_name("the name of an open file");
    next();
    last_span_ = t.tree->exprs[call->callee].span;
    for (std::uint32_t i = call->args.count; i-- > 0;) {
      Token value = t;
      value.expr = t.tree->expr_lists[call->args.first + i];
      value.span = t.tree->exprs[value.expr].span;
      unread(value);
    }
    return name->name;
  };
  in_parentheses("write", [&](auto at_end) {
    const SymbolId name = read_file_name();
    // The file may be closed only after this directive: keep hold of it.
    DataFile& file = file_named(name, last_span_);
    if (file.mode() == DataFile::Mode::read) {
      fail(Code::evaluation, last_span_, fmt::format("`{}` was opened for reading", name_of(name)));
    }
    optional_comma();
    BinaryFormat format;
    while (!at_end()) {
      const Token t = peek();
      if (t.is_punct(',')) {
        next();
        format = {};  // a format holds up to the next comma
      } else if (t.kind == Token::Kind::word && format_of(t.word).bytes > 0) {
        next();
        format = format_of(t.word);
      } else if (t.kind == Token::Kind::expr && is_text(*t.tree, t.expr)) {
        file.write(read_text().bytes());
      } else {
        const Num n = read_num(1);
        file.write(format.bytes > 0 ? as_bytes(n, format) : as_text(n));
      }
    }
    if (!file.good())
      fail(Code::file_not_written, last_span_, fmt::format("cannot write to `{}`", file.path()));
  });
}

void Interpreter::read_file() {
  in_parentheses("read", [&](auto at_end) {
    const SymbolId name = read_name("the name of an open file");
    const Span at = last_span_;
    DataFile& file = file_named(name, at);
    if (file.mode() != DataFile::Mode::read) {
      fail(Code::evaluation, at, fmt::format("`{}` was not opened for reading", name_of(name)));
    }
    optional_comma();
    while (!at_end()) {
      const Token t = next();
      optional_comma();
      if (file.at_end()) continue;
      Value* target = nullptr;
      if (const auto* id = t.node<ast::Name>(); id != nullptr && !symbols_.reserved(id->name)) {
        Slot* slot = env_.find(id->name);
        target = slot != nullptr ? Environment::value_of(slot) : &env_.for_global(id->name).value;
      } else if (t.kind == Token::Kind::expr && array_of(t.expression())) {
        target = element(*array_of(t.expression()), read_subscripts(*t.tree, t.expr), t.span, true,
                         false);
      }
      if (target == nullptr) unexpected(t, "a variable to read into");
      if (target->defined() && !target->is_num() && target->get<Shared<Text>>() == nullptr) {
        fail(Code::wrong_kind, t.span,
             fmt::format("only numbers, vectors and strings are read into; this is {}", kind_name(*target)));
      }
      const DataFile::Datum datum = file.read();
      if (const auto* bad = std::get_if<DataFile::Bad>(&datum)) {
        fail(Code::evaluation, at, fmt::format("{} in `{}`", bad->what, file.path()));
      } else if (const auto* n = std::get_if<Num>(&datum)) {
        *target = Value(*n);
      } else if (const auto* s = std::get_if<std::string>(&datum)) {
        Text text;
        decode_literal(*s, at, false, text);
        *target = text_value(std::move(text));
      }
    }
    if (file.at_end()) env_.undefine(name);
  });
}

}  // namespace durer::interpreter
