// What all maps share: `{ Identifier }` or `{ [key …] … }` (textures §11.1).
#pragma once

#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

/// Reads a map of the kind `name` into `map`. `read_entry` gets the key of every entry and reads
/// the rest of it up to and including `]`. `weights`: the keys are weights, which may be missing.
template <typename Map, typename ReadEntry>
void Interpreter::read_map(std::string_view name, Map& map, bool weights, ReadEntry read_entry) {
  expect_open(name);
  if (const Token t = peek(); t.kind == Token::Kind::expr) {
    const Value* v = lookup(*t.tree, t.expr, true);
    if (v != nullptr) {
      if (const auto* missing = v->get<Shared<Unsupported>>()) {
        not_supported((*missing)->feature, t.span);
      }
    }
    const auto* ref = v == nullptr ? nullptr : v->get<Shared<Map>>();
    if (ref == nullptr) unexpected(t, fmt::format("the name of a `{}`, or `[`", name));
    next();
    map = **ref;
  }
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.kind != Token::Kind::bracket_open) unexpected(t, fmt::format("`[` or `}}` in `{}`", name));
    float key = 1;
    if (!weights || starts_number(peek())) key = static_cast<float>(read_scalar("key"));
    optional_comma();
    last_span_ = t.span;
    read_entry(key);
  }
  if (map.entries.empty()) {
    fail(Code::missing_argument, peek().span, "a map needs at least one entry");
  }
  if (map.entries.size() > 256) fail(Code::limit, peek().span, "a map has at most 256 entries");
}

}  // namespace durer::interpreter
