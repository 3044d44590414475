#include "tracer/transport/photon_shooting.h"

#include <atomic>
#include <memory>

#include "tracer/film/threads.h"
#include "tracer/random.h"
#include "tracer/transport/photon_tracer.h"

namespace durer::tracer {
namespace {

// A part of one ring: the work of one thread for a moment.
struct Share {
  int ring = 0;
  PhotonRing shape;
  int first = 0;
  int end = 0;
  bool met = false;  // some photon met the target
  PhotonLists caught;
};

// What one thread needs.
struct Gunner {
  explicit Gunner(const CompiledScene& scene) : scratch(scene), tracer(scene, scratch) {}
  Scratch scratch;
  PhotonTracer tracer;
};

class Shooting {
 public:
  Shooting(const CompiledScene& scene, int threads, ProgressMeter& meter)
      : scene_(scene),
        settings_(*scene.scene->settings.photons),
        threads_(threads),
        meter_(meter),
        gunners_(static_cast<std::size_t>(threads)) {}

  // Rings go in waves, so that those behind the last useful one are few. A wave is worked on by all
  // threads, and its catch taken in the order of its rings.
  void shoot(const PhotonPair& pair, std::uint32_t number) {
    constexpr int wave = 1 << 14;  // photons
    constexpr int share = 256;
    bool met = false;
    const int rings = pair.rings();
    for (int ring = 0; ring < rings && !meter_.cancelled();) {
      std::vector<Share> shares;
      for (int photons = 0; ring < rings && photons < wave; ++ring) {
        const PhotonRing shape = ring_of(pair, ring, seed(number, ring, 0));
        photons += shape.count;
        for (int i = 0; i < shape.count; i += share) {
          shares.push_back({ring, shape, i, std::min(i + share, shape.count), false, {}});
        }
      }
      work(pair, number, shares);
      if (!take(pair, shares, met)) return;
    }
  }

  PhotonLists caught() && { return std::move(all_); }

 private:
  [[nodiscard]] static std::uint32_t seed(std::uint32_t pair, int ring, int photon) {
    return mixed(mixed(mixed(pair + 1) + static_cast<std::uint32_t>(ring)) +
                 static_cast<std::uint32_t>(photon));
  }

  void work(const PhotonPair& pair, std::uint32_t number, std::vector<Share>& shares) {
    std::atomic<std::size_t> next{0};
    on_threads(threads_, [&](int thread) {
      std::unique_ptr<Gunner>& own = gunners_[static_cast<std::size_t>(thread)];
      if (!own) own = std::make_unique<Gunner>(scene_);
      const std::uint64_t before = own->scratch.rays;
      for (std::size_t i = next++; i < shares.size() && !meter_.cancelled(); i = next++) {
        shoot(pair, number, shares[i], *own);
      }
      meter_.add(0, own->scratch.rays - before);
    });
  }

  void shoot(const PhotonPair& pair, std::uint32_t number, Share& share, Gunner& gunner) const {
    for (int i = share.first; i < share.end; ++i) {
      gunner.scratch.noise = seed(number, share.ring, i + 1);
      EmittedPhoton photon;
      if (!emitted(pair, share.shape, i, settings_.jitter, gunner.scratch.noise, photon)) continue;
      share.met |= gunner.tracer.shoot(pair, photon, share.caught);
    }
  }

  // False if a ring has gone past the target, and no more are wanted.
  bool take(const PhotonPair& pair, const std::vector<Share>& shares, bool& met) {
    const auto append = [](std::vector<Photon>& to, const std::vector<Photon>& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    for (std::size_t i = 0; i < shares.size();) {
      const int ring = shares[i].ring;
      bool now = false;
      for (; i < shares.size() && shares[i].ring == ring; ++i) {
        now |= shares[i].met;
        append(all_.surfaces, shares[i].caught.surfaces);
        append(all_.media, shares[i].caught.media);
      }
      if (met && !now && pair.ring(ring) > settings_.autostop * pair.end) return false;
      met |= now;
    }
    return true;
  }

  const CompiledScene& scene_;
  const scene::Photons& settings_;
  int threads_;
  ProgressMeter& meter_;
  std::vector<std::unique_ptr<Gunner>> gunners_;
  PhotonLists all_;
};

PhotonLists shoot_all(const CompiledScene& scene, int threads, ProgressMeter& meter) {
  const std::vector<PhotonPair> pairs = plan_photons(scene);
  Shooting shooting(scene, threads, meter);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    shooting.shoot(pairs[i], static_cast<std::uint32_t>(i));
  }
  return std::move(shooting).caught();
}

PhotonGathering gathering(const scene::Photons& s, const PhotonMap& map, bool flat) {
  PhotonGathering g;
  g.least = static_cast<std::size_t>(s.gather_min);
  g.most = static_cast<std::size_t>(s.gather_max);
  const double given = flat ? s.surface_radius : s.media_radius;
  const double factor = flat ? s.surface_factor : s.media_factor_of_radius;
  g.radius = factor * (given > 0 ? given : usual_radius(map, g.most, flat));
  if (!flat) g.radius *= 2;
  g.expand_increase = s.expand_increase;
  g.expand_min = static_cast<std::size_t>(s.expand_min);
  return g;
}

}  // namespace

PhotonMaps shoot_photons(const CompiledScene& scene, int threads, ProgressMeter& meter,
                         std::string& warning) {
  PhotonMaps maps;
  const std::optional<scene::Photons>& settings = scene.scene->settings.photons;
  if (!settings || !scene.quality.photons || settings->gather_max == 0) return maps;
  PhotonLists caught = settings->loaded.empty()
                           ? shoot_all(scene, threads, meter)
                           : decode_photons(settings->loaded).value_or(PhotonLists{});
  if (!settings->save_file.empty() && !meter.cancelled()) {
    warning = write_photons(caught, settings->save_file).value_or("");
  }
  maps.surfaces = PhotonMap(std::move(caught.surfaces));
  maps.media = PhotonMap(std::move(caught.media));
  maps.on_surfaces = gathering(*settings, maps.surfaces, true);
  maps.in_media = gathering(*settings, maps.media, false);
  return maps;
}

}  // namespace durer::tracer
