// The scene of one frame, read by the interpreter.
#pragma once

#include <memory>
#include <optional>

#include "base/diagnostic.h"
#include "cli/console.h"
#include "cli/scene_file.h"
#include "cli/sequence.h"
#include "scene/object_queries.h"
#include "scene/pigment_queries.h"
#include "scene/scene.h"

namespace durer::cli {

/// A scene with all that its places and messages refer to.
struct FrameScene {
  SourceMap sources;
  Diagnostics diagnostics{sources};
  std::unique_ptr<scene::ObjectQueries> queries;
  std::unique_ptr<scene::PigmentQueries> pigments;
  std::optional<scene::Scene> scene;  // empty: there were errors
  std::string assumed;                // what the scene left open, in one line
  double seconds = 0;                 // of reading
};

/// Everything starts afresh for each frame: names, random numbers, messages. What the scene says
/// goes to the console as it comes; the diagnostics are not printed yet.
[[nodiscard]] std::unique_ptr<FrameScene> read_frame(const Settings& settings,
                                                     const SceneText& text, const FrameTask& task,
                                                     Console& console);

/// What a frame was made of and nobody needs any more: destroyed before the next frame is read. That
/// of the last frame is left to the system, which takes the memory of a million objects back at
/// once. First what refers to the others.
void leave_behind(std::shared_ptr<const void> part);

/// Prints the scene as data on standard output; false if that cannot be written.
[[nodiscard]] bool dump(const FrameScene& frame, const Settings& settings);

}  // namespace durer::cli
