// The scene as text or JSON, for people who debug scenes and for tests.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "base/source.h"
#include "scene/scene.h"

namespace durer::scene {

enum class DumpStyle : std::uint8_t {
  text,  // indented; what has its default value is left out
  json,  // one document; everything
};

/// Writes every struct of the scene with every field, in pieces of any size, through `write`.
/// Primitives, patterns and their operands have the names of `registry`; ids are indices into the
/// lists of the scene. With `sources`, origins are file, line and column, with the chain of calls
/// and includes; without, they are left out, and scenes that look alike are written alike.
void dump(const Scene& scene, const Registry& registry, const SourceMap* sources, DumpStyle style,
          const std::function<void(std::string_view)>& write);

/// The same as one string.
[[nodiscard]] std::string dump_text(const Scene& scene, const Registry& registry,
                                    const SourceMap* sources, DumpStyle style);

}  // namespace durer::scene
