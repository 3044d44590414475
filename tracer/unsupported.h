#pragma once

#include "base/diagnostic.h"
#include "scene/scene.h"

namespace durer::tracer {

/// Reports features that cannot be rendered, each place and feature once, with the chain of macro
/// calls and includes that led there.
class UnsupportedReport {
 public:
  /// `paths`: what random paths cannot render is reported too.
  UnsupportedReport(const scene::Scene& scene, Diagnostics& diagnostics, bool paths = false)
      : scene_(&scene), diagnostics_(&diagnostics), paths_(paths) {}

  /// Everything reachable from a texture or interior that is in use.
  void check_texture(scene::TextureId texture, std::uint32_t depth = 0);
  void check_interior(scene::InteriorId interior);
  void check_media(std::span<const scene::Media> media);

  void check_pigment(const scene::Pigment& pigment);
  void check_sky_pigment(const scene::Pigment& pigment);

 private:
  void check_normal(const scene::Normal& normal);
  void check_finish(const scene::Finish& finish, scene::OriginId origin);
  void report(std::string_view feature, scene::OriginId origin);

  const scene::Scene* scene_;
  Diagnostics* diagnostics_;
  bool paths_;
  std::vector<bool> textures_seen_;
  std::vector<bool> interiors_seen_;
  std::vector<std::pair<std::string, scene::OriginId>> reported_;
};

}  // namespace durer::tracer
