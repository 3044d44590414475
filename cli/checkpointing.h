// Keeps half a picture on disk while it is rendered.
#pragma once

#include <optional>
#include <string>

#include "cli/state_file.h"

namespace durer::cli {

class Checkpointing {
 public:
  /// `path` empty: nothing is kept. `scene` must live as long.
  Checkpointing(std::string path, const scene::Scene& scene, const tracer::RenderOptions& options)
      : path_(std::move(path)), scene_(scene), options_(options), checkpoint_(options) {}

  /// Takes up the state on disk, if there is one; returns why it cannot.
  [[nodiscard]] std::optional<std::string> take_up();
  /// Called while rendering; writes the state from time to time. An unwritable file is no reason to
  /// stop: the picture itself is not yet lost.
  void save_now_and_then(const tracer::Progress& progress);
  /// Writes the state; returns why it is lost.
  [[nodiscard]] std::optional<std::string> save();
  /// The picture is complete.
  void remove();

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] tracer::Checkpoint& checkpoint() { return checkpoint_; }

 private:
  [[nodiscard]] std::uint64_t print();

  std::string path_;
  const scene::Scene& scene_;
  tracer::RenderOptions options_;
  tracer::Checkpoint checkpoint_;
  std::optional<std::uint64_t> print_;  // made when first needed: it reads the whole scene
  double next_ = 10;                    // seconds of rendering
};

}  // namespace durer::cli
