// One picture, from the text of its scene to its file.
#pragma once

#include "cli/console.h"
#include "cli/output_name.h"
#include "cli/scene_file.h"
#include "cli/sequence.h"

namespace durer::cli {

/// Where the picture of this frame goes.
[[nodiscard]] Output output_of(const Settings& settings, const FrameTask& task);

/// Reads and renders one frame and writes its picture, or skips it if that is there already and
/// Continue_Trace wants it so. Returns an exit code; messages have been printed.
[[nodiscard]] int render_frame(const Settings& settings, const SceneText& text, Console& console,
                               const FrameTask& task);

}  // namespace durer::cli
