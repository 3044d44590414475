// Media along a piece of a ray (participating-and-global §1.3-1.12).
#pragma once

#include "tracer/transport/trace.h"

namespace durer::tracer {

/// Integrates over the media of one piece of a ray. Several of them, from all bodies around, act at
/// once; the one with most intervals rules how they are sampled.
class MediaIntegrator {
 public:
  /// What matters about the ray besides its way.
  struct Setting {
    const Containment& inside;               // bodies that it is in, for shadow rays from within
    std::span<const std::uint32_t> lamps{};  // that may light the media
    bool gathering = false;                  // it gathers indirect light
    bool shadow = false;                     // it goes to a lamp: only what is lost counts
  };

  /// `ray.d` of unit length.
  MediaIntegrator(Tracer& tracer, const Ray& ray, double depth, const Setting& setting);
  MediaIntegrator(const MediaIntegrator&) = delete;
  MediaIntegrator& operator=(const MediaIntegrator&) = delete;
  ~MediaIntegrator();

  void add(MediaRange media);
  [[nodiscard]] MediaEffect integrate();

  // A part of the ray, between t and t + length.
  struct Interval {
    double t = 0;
    double length = 0;
    bool lit = false;
  };
  /// Where photons on the ray are left behind: stretches that are divided on their own. None if the
  /// media do not scatter, or do not want photons.
  void find_stretches(std::vector<Interval>& out);

 private:
  using Sample = MediaSample;
  // What media do at a place, per unit of length.
  struct Matter {
    vec3 extinction{0.0F};
    vec3 emission{0.0F};
    vec3 scattering{0.0F};
    void add(const MediaProgram& m, vec3 density) {
      extinction += density * m.extinction;
      emission += density * m.emission;
      scattering += density * m.scattering;
    }
  };
  [[nodiscard]] const MediaProgram& media(std::uint32_t i) const;
  void find_leader();
  void find_parts();
  template <typename Visit>  // visit(interval) returns false where nothing more is wanted
  void each_interval(Visit visit);
  void integrate(const Interval& interval, MediaEffect& effect);
  [[nodiscard]] Sample sampled(const Interval& interval);
  [[nodiscard]] Sample uniform(const Interval& interval);
  [[nodiscard]] Sample adaptive(const Interval& interval);
  std::size_t divide(const Interval& interval, MediaSamples& all);
  void halve(MediaSamples& all, std::size_t index) const;
  static void find_mean(MediaSamples& all, std::size_t index, bool undivided);
  [[nodiscard]] Sample at(const Interval& interval, double u);
  void fill(const Interval& interval, std::span<Sample> samples);
  void find_matter(std::span<const dvec3> points, Matter* out) const;
  [[nodiscard]] Sample dimmed(const Interval& interval, double u);
  void add_scattered(const double* t, std::span<const dvec3> points, Matter* matter);
  [[nodiscard]] vec3 arriving(std::size_t index, const Light& light, const Incidence& in, dvec3 p);
  void find_casters(std::size_t span, const Light& light);
  [[nodiscard]] double last_sample(const LampSpan& span) const;
  [[nodiscard]] double left_out() const;
  [[nodiscard]] vec3 photons_at(dvec3 p);
  [[nodiscard]] double mean_phase(double cosine) const;
  [[nodiscard]] double random();

  Tracer& tracer_;
  const CompiledScene& scene_;
  Scratch& scratch_;
  const Ray ray_;
  const double length_;
  const Setting setting_;
  // Of scratch_.media, a stack.
  const std::uint32_t first_;
  std::uint32_t end_;

  const MediaProgram* leader_ = nullptr;
  float aa_threshold_ = 0;
  bool constant_ = true;  // in the sense of shadow rays: MediaProgram::constant
  bool varies_ = false;
  bool scatters_ = false;
  bool dims_ = false;
  bool collects_ = false;
  bool isotropic_ = true;
  Matter matter_;  // everywhere, if nothing varies
  bool has_photons_ = false;  // that may light these media
};

/// Appends where some of the `lights`, the `lamps`, shine on a ray: [0, depth] or less for those with a cone. Then parts of the
/// ray, some lit, some not, from 0 to `depth`.
void find_lit_parts(std::span<const Light> lights, std::span<const std::uint32_t> lamps,
                    const Ray& ray, double depth, std::vector<LampSpan>& spans,
                    std::vector<LitPart>& parts);

}  // namespace durer::tracer
