// One sample of the picture: through camera and lens into the scene (shading §2).
#pragma once

#include <span>
#include <vector>

#include "tracer/cameras/camera.h"
#include "tracer/film/antialias.h"
#include "tracer/film/lens.h"
#include "tracer/film/pinhole.h"
#include "tracer/render.h"
#include "tracer/shading/normal.h"
#include "tracer/transport/path_tracer.h"

namespace durer::tracer {

/// What samples of a picture need and no thread changes.
struct Viewpoint {
  Viewpoint(const CompiledScene& scene, const RenderOptions& options);

  const CompiledScene* scene;
  const RenderOptions* options;
  Camera camera;
  LensSampling lens;
  NormalStore bumps;  // of the camera
  NormalId bump = scene::none;
  bool one_origin = true;     // all rays start where the camera is
  bool bodies_matter = true;  // to what is seen: those that hold the place where a ray starts
  dvec3 lens_right{0.0};      // unit: axes of the lens …
  dvec3 lens_up{0.0};
  double lens_scale = 1;  // … and from the camera's directions to places that are in focus
  int turns = 1;          // rays per sample
  bool direct = true;     // one ray per sample, and through a pinhole
  Pinhole pinhole;        // if that is all there is to the camera
  double reach = no_hit_depth;
  const PhotonMaps* photons = nullptr;  // once they are shot
};

/// Looks, on behalf of one thread.
class Eye {
 public:
  explicit Eye(const Viewpoint& view);

  /// The picture at (x, y), in pixels: whole numbers are centres. `index` tells the samples of a
  /// pixel apart.
  [[nodiscard]] Pixel see(double x, double y, std::uint32_t index) {
    return view_->direct ? see_directly(x, y, index) : see_all(x, y, index);
  }
  /// The same at several spots, which is faster where these are neighbours.
  void see(std::span<const Spot> spots, Pixel* out);
  /// The same at the centres of the pixels of a whole square (square_edge), row by row.
  void see_square(int left, int top, Pixel* out);

  /// One random path from somewhere in the pixel, and through somewhere of the lens.
  [[nodiscard]] Pixel sample(int x, int y, std::uint32_t index);

  /// Before a block of the final picture: what is known of indirect light. `seed` is its own.
  void begin(const IrradianceCache* cache, std::uint32_t seed);
  /// The same for one ray through the middle of the lens, for the sake of what it gathers.
  void probe(double x, double y) { plain(x, y, 0); }
  [[nodiscard]] RadiosityState& radiosity() { return scratch_.radiosity; }

  [[nodiscard]] std::uint64_t rays() const { return scratch_.rays; }

 private:
  [[nodiscard]] Pixel see_directly(double x, double y, std::uint32_t index);
  [[nodiscard]] Pixel see_all(double x, double y, std::uint32_t index);
  [[nodiscard]] inline bool camera_ray(double x, double y, int turn, CameraRay& out);
  Pixel plain(double x, double y, std::uint32_t index);
  [[nodiscard]] Pixel through_lens(dvec2 at, dvec2 pixel, std::uint32_t index, int sample);
  [[nodiscard]] Pixel look_along(const CameraRay& ray, double x, double y, std::uint32_t index);
  void see_some(std::span<const Spot> spots, Pixel* out);
  void see_through_pinhole(std::span<const Spot> spots, Pixel* out);
  inline void see_through_pinhole(std::size_t count, Pixel* out);
  inline void start(const CameraRay& ray, const dvec3& d, Path& path);
  void find_around(const dvec3& p, Containment& inside);
  [[nodiscard]] dvec3 unit(const dvec3& d);

  const Viewpoint* view_;
  Scratch scratch_;
  Tracer tracer_;
  PathTracer paths_;
  SobolSampler random_;
  functions::Workspace workspace_;
  std::vector<Sample> samples_;  // that are taken together
  PinholeRays rays_;             // likewise, through a pinhole
  Path start_;                   // of those through a pinhole, but for its direction
  dvec3 last_d_{0.0};            // the camera's direction of the last ray …
  dvec3 last_unit_{0.0};         // … and the same with unit length
};

}  // namespace durer::tracer
