// The patterns `density_file` and `object`, which look at something beside the point (textures
// §8.3, §8.6).
#include <filesystem>

#include <fmt/format.h>

#include "base/read_file.h"
#include "functions/builder.h"
#include "interpreter/interpreter.h"
#include "scene/image.h"

namespace durer::interpreter {

namespace w = grammar::words;

/// `df3 "file"`: three sizes of 16 bits, then the samples; how wide these are, the length tells.
std::shared_ptr<const scene::Voxels> Interpreter::read_voxels() {
  if (!accept(w::df3)) unexpected(peek(), "`df3` after `density_file`");
  const Span span = peek().span;
  const std::string name = read_text(true).bytes();
  constexpr std::array<std::string_view, 1> suffixes = {".df3"};
  const auto path = find_file(name, span, suffixes);
  if (!path) missing_file(name, span, suffixes);
  auto& known = voxels_[*path];
  if (known) return known;

  const std::optional<std::string> bytes = durer::read_file(*path);
  const auto broken = [&](std::string why) {
    fail(Code::file_not_found, span, fmt::format("`{}` is no density file: {}", *path, why));
  };
  if (!bytes) broken("it cannot be read");
  if (bytes->size() < 6) broken("it is too short");
  auto voxels = std::make_shared<scene::Voxels>();
  std::uint64_t count = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>((*bytes)[k]); };
    voxels->size[i] = static_cast<std::uint32_t>(byte(2 * i) << 8 | byte(2 * i + 1));
    count *= voxels->size[i];
  }
  const std::uint64_t length = bytes->size() - 6;
  if (count == 0 || (length != count && length != 2 * count && length != 4 * count)) {
    broken(fmt::format("{} bytes are no {} samples of 1, 2 or 4 bytes", length, count));
  }
  voxels->width = static_cast<std::uint32_t>(length / count);
  voxels->bytes.assign(bytes->begin() + 6, bytes->end());
  known = std::move(voxels);
  return known;
}

/// `{` and what the pattern is inside of. The list and the closing mark are left.
void Interpreter::read_object_pattern(scene::Pattern& pattern, Span span) {
  expect_open("object");
  const Token t = next();
  scene::ObjectId id = scene::none;
  if (t.kind == Token::Kind::expr) {
    const Value* v = lookup(*t.tree, t.expr, false);
    if (v != nullptr && v->get<ObjectRef>() != nullptr) id = v->get<ObjectRef>()->id;
  } else if (starts_object(t)) {
    id = read_object(t);
  }
  if (id == scene::none) unexpected(t, "an object in the pattern `object`");
  if (options_.queries == nullptr || options_.pigments == nullptr) {
    not_supported("the pattern `object` without a tracer", span);
  }
  if (const auto feature = options_.queries->unsupported(scene_, id)) not_supported(*feature, t.span);
  pattern.function = std::make_shared<const functions::Function>(
      functions::make_external_function(options_.pigments->inside_function(scene_, id)));
}

}  // namespace durer::interpreter
