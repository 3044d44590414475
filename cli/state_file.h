// Half a picture on disk, for +C (Continue_Trace) after an interruption.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "scene/scene.h"
#include "tracer/render.h"

namespace durer::cli {

/// Beside the picture; empty if the picture does not go to a file.
[[nodiscard]] std::string state_path(const std::string& output);

/// What must be the same for a state to be of use: the scene as data (not as text: comments may
/// change) and everything else that makes the picture. Threads do not.
[[nodiscard]] std::uint64_t fingerprint(const scene::Scene& scene, const scene::Registry& registry,
                                        const tracer::RenderOptions& options);

/// Writes the state so that the file is whole or as it was before; returns what went wrong.
[[nodiscard]] std::optional<std::string> write_state(const std::string& path,
                                                     std::uint64_t fingerprint,
                                                     const tracer::Checkpoint::State& state);

/// A state, or why there is none: the file is damaged, or of another scene or other options.
struct StateRead {
  tracer::Checkpoint::State state;
  std::optional<std::string> error;
};
[[nodiscard]] StateRead read_state(const std::string& path, std::uint64_t fingerprint);

}  // namespace durer::cli
