// Settings → what the libraries want to know.
#pragma once

#include <string>

#include "cli/sequence.h"
#include "cli/settings.h"
#include "cli/window.h"
#include "interpreter/interpret.h"
#include "tracer/render.h"

namespace durer::cli {

[[nodiscard]] interpreter::Options interpreter_options(const Settings& settings,
                                                       const FrameTask& task);
[[nodiscard]] tracer::RenderOptions render_options(const Settings& settings, const Window& window);
/// How the picture of a scene with these settings is stored (shading §1.2, §1.5).
[[nodiscard]] image::Encoding encoding_of(const Settings& settings, const scene::Settings& scene);
/// What was taken for granted, in one line: "language 3.62 (no #version); gamma …", as the
/// interpreter tells it, but for what options change about it.
[[nodiscard]] std::string assumptions(const Settings& settings, const scene::Settings& scene,
                                      const std::string& of_the_scene);

}  // namespace durer::cli
