// The way of one photon (participating-and-global §3.5, §3.6).
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/transport/media.h"
#include "tracer/transport/photon_file.h"
#include "tracer/transport/photon_plan.h"

namespace durer::tracer {

/// Follows photons on behalf of one thread.
class PhotonTracer {
 public:
  PhotonTracer(const CompiledScene& scene, Scratch& scratch);

  /// Sends a photon of `pair` on its way. True if it met its target.
  bool shoot(const PhotonPair& pair, const EmittedPhoton& photon, PhotonLists& out);

 private:
  // A photon between two surfaces.
  struct Flight {
    Path path;
    vec3 colour{0.0F};
    double way = 0;  // from the lamp to the start of the ray
    int hits = 0;    // surfaces so far, those that it passed through not counted
  };
  // What the flight was started with.
  struct Journey {
    const PhotonPair& pair;
    PhotonLists& out;
    bool on_target = false;
  };
  using View = Tracer::View;
  using LayerSum = Tracer::LayerSum;

  void follow(Flight flight, Journey& journey);
  void start_inside(Flight& flight) const;
  [[nodiscard]] bool goes_on(const Flight& flight, const PhotonTraits& surface,
                             Journey& journey) const;
  void through_media(Flight& flight, const Hit& hit, const PhotonTraits& surface,
                     Journey& journey);
  void leave_in_media(const Flight& flight, const Hit& hit, Journey& journey);
  void leave(const Flight& flight, dvec3 p, vec3 colour, double way, const PhotonPair& pair,
             std::vector<Photon>& out) const;
  void bounce(const View& view, const Flight& flight, const PhotonTraits& traits,
              Journey& journey);
  [[nodiscard]] LayerSum layers(const View& view, const Path& path);
  void reflect(const View& view, const LayerSum& layers, const Flight& flight, std::size_t first,
               bool tir, Journey& journey);
  bool transmit(const View& view, const LayerSum& layers, const Flight& flight, Journey& journey);

  const CompiledScene& scene_;
  Scratch& scratch_;
  Tracer tracer_;
  int max_level_;
  float adc_;
  std::vector<MediaIntegrator::Interval> stretches_;
};

}  // namespace durer::tracer
