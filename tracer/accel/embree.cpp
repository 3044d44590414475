// Embree chooses whom to ask: one user geometry per sort of target, boxes in single precision
// rounded outward. The answers, in double precision, live in the query.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "base/bounds.h"
#include "tracer/accel/accel.h"
#include "tracer/accel/box_tree.h"
#include "tracer/accel/embree_api.h"

namespace durer::tracer {
namespace {

constexpr float float_infinity = std::numeric_limits<float>::infinity();

#if RTC_VERSION_MAJOR >= 4
using EmbreeContext = RTCRayQueryContext;
void init_context(EmbreeContext& context) { rtcInitRayQueryContext(&context); }
#else
using EmbreeContext = RTCIntersectContext;
void init_context(EmbreeContext& context) { rtcInitIntersectContext(&context); }
#endif

/// What a callback finds behind the context pointer that Embree hands through.
struct Travelling : EmbreeContext {
  RayQuery* query = nullptr;
  double t_start = 0;  // of Embree's ray, on ours
};

float round_down(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) > x ? std::nextafter(f, -float_infinity) : f;
}
float round_up(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) < x ? std::nextafter(f, float_infinity) : f;
}
/// For depths: not the nearest float above, but one that costs a multiplication.
float depth_above(double t) { return static_cast<float>(t * (1 + 1e-6)); }

/// The part of the scene that Embree is told of.
struct Region {
  Bounds3 box;        // of everything in it
  double reach = 0;   // greatest coordinate in it
  dvec3 center{0.0};  // boxes and rays are given relative to it
  /// Embree rounds our ray to single precision and steps along it in single precision: errors of
  /// a few 2^-24 of the region's size, which the boxes must cover.
  double pad = 0;
};

/// What the bounds callback needs.
struct Member {
  const Targets* targets = nullptr;
  const Region* region = nullptr;
};

double reach_of(const Bounds3& b) {
  double reach = 0;
  for (int i = 0; i < 3; ++i) reach = std::max({reach, std::abs(b.lo[i]), std::abs(b.hi[i])});
  return reach;
}

void bounds_callback(const RTCBoundsFunctionArguments* args) {
  const auto& member = *static_cast<const Member*>(args->geometryUserPtr);
  const Bounds3 b = member.targets->surface_bounds(args->primID);
  RTCBounds& out = *args->bounds_o;
  const Region& region = *member.region;
  if (b.empty() || b.infinite() || reach_of(b) > region.reach) {  // a box that Embree leaves out
    out.lower_x = out.lower_y = out.lower_z = float_infinity;
    out.upper_x = out.upper_y = out.upper_z = -float_infinity;
    return;
  }
  const dvec3 lo = b.lo - region.center - region.pad;
  const dvec3 hi = b.hi - region.center + region.pad;
  out.lower_x = round_down(lo.x), out.lower_y = round_down(lo.y), out.lower_z = round_down(lo.z);
  out.upper_x = round_up(hi.x), out.upper_y = round_up(hi.y), out.upper_z = round_up(hi.z);
}

bool ask(void* user, std::uint32_t index, void* context) {
  const Targets& targets = *static_cast<const Member*>(user)->targets;
  RayQuery& query = *static_cast<Travelling*>(context)->query;
  const double before = query.t_to;
  targets.nearest(targets, index, query);
  return query.t_to < before;
}

void intersect_callback(const RTCIntersectFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  auto& travelling = *static_cast<Travelling*>(args->context);
  if (!ask(args->geometryUserPtr, args->primID, &travelling)) return;
  RTCRayN* ray = RTCRayHitN_RayN(args->rayhit, 1);
  RTCRayN_tfar(ray, 1, 0) = depth_above(travelling.query->t_to - travelling.t_start);
}

void occluded_callback(const RTCOccludedFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  if (!ask(args->geometryUserPtr, args->primID, args->context)) return;
  RTCRayN_tfar(args->ray, 1, 0) = -float_infinity;
}

/// A reference to the device that all hierarchies share.
RTCDevice shared_device() {
  static const std::unique_ptr<std::remove_pointer_t<RTCDevice>, decltype(&rtcReleaseDevice)> device(
      rtcNewDevice(nullptr), &rtcReleaseDevice);
  rtcRetainDevice(device.get());
  return device.get();
}

class EmbreeAccel final : public Accel {
 public:
  explicit EmbreeAccel(std::span<const Targets* const> all) {
    collect(all);
    if (!few_.empty() || region_.box.empty()) return;
    device_ = shared_device();
    scene_ = rtcNewScene(device_);
    members_.reserve(all.size());
    for (const Targets* targets : all) {
      if (targets->size() > 0) attach(members_.emplace_back(Member{targets, &region_}));
    }
    rtcCommitScene(scene_);
  }
  ~EmbreeAccel() override {
    if (device_ == nullptr) return;
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeAccel(const EmbreeAccel&) = delete;
  EmbreeAccel& operator=(const EmbreeAccel&) = delete;

  void closest(RayQuery& query) const override {
    for (const Lone& lone : lone_) lone.targets->nearest(*lone.targets, lone.index, query);
    if (!few_.empty()) return ask_few(query);
    if (scene_ != nullptr) intersect(query);
  }

  bool any(RayQuery& query) const override {
    for (const Lone& lone : lone_) {
      lone.targets->nearest(*lone.targets, lone.index, query);
      if (query.found.store != nullptr) return true;
    }
    if (!few_.empty()) {
      ask_few(query);
      return query.found.store != nullptr;
    }
    return scene_ != nullptr && occlude(query);
  }

 private:
  // These two need much room on the stack, which is not to be made for scenes without them.
  [[gnu::noinline]] void intersect(RayQuery& query) const {
    Travelling context;
    RTCRayHit rayhit;
    if (!prepare(query, context, rayhit.ray)) return;
    rayhit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rayhit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    RTCIntersectArguments args;
    rtcInitIntersectArguments(&args);
    args.context = &context;
    rtcIntersect1(scene_, &rayhit, &args);
#else
    rtcIntersect1(scene_, &context, &rayhit);
#endif
  }

  [[gnu::noinline]] bool occlude(RayQuery& query) const {
    Travelling context;
    RTCRay ray;
    if (!prepare(query, context, ray)) return false;
#if RTC_VERSION_MAJOR >= 4
    RTCOccludedArguments args;
    rtcInitOccludedArguments(&args);
    args.context = &context;
    rtcOccluded1(scene_, &ray, &args);
#else
    rtcOccluded1(scene_, &context, &ray);
#endif
    return query.found.store != nullptr;
  }

  static constexpr std::size_t few_objects = 4;

  struct Lone {
    const Targets* targets;
    std::uint32_t index;
  };
  struct Boxed {
    Bounds3 box;
    Lone target;
  };
  struct Finite {
    double reach;
    Lone target;
  };

  /// A few huge or distant objects, a sky or a sun, would coarsen the boxes of all others: what
  /// makes the region more than `dominance` times larger stays outside with the endless objects.
  void collect(std::span<const Targets* const> all) {
    constexpr std::size_t most = 8;  // more such objects are a scene of their own
    constexpr double dominance = 8;
    std::vector<Finite> finite;
    for (const Targets* targets : all) {
      for (std::uint32_t i = 0; i < targets->size(); ++i) {
        const Bounds3 b = targets->surface_bounds(i);
        if (b.empty()) continue;
        if (b.infinite()) {
          lone_.push_back({targets, i});
        } else {
          finite.push_back({reach_of(b), {targets, i}});
        }
      }
    }
    if (finite.empty()) return;
    if (finite.size() <= few_objects) {
      for (const Finite& f : finite) {
        few_.push_back(
            {BoxTree::grown(f.target.targets->surface_bounds(f.target.index)), f.target});
      }
      find_companion();
      return;
    }
    const std::size_t few = std::min(most + 1, finite.size());
    std::partial_sort(finite.begin(), finite.begin() + static_cast<std::ptrdiff_t>(few),
                      finite.end(),
                      [](const Finite& a, const Finite& b) { return a.reach > b.reach; });
    std::size_t outside = 0;
    for (std::size_t k = 1; k < few; ++k) {
      if (finite[k - 1].reach > dominance * finite[k].reach) outside = k;
    }
    region_.reach = finite[outside].reach;
    for (const Finite& f : finite) {
      if (f.reach > region_.reach) {
        lone_.push_back(f.target);
      } else {
        region_.box.add(f.target.targets->surface_bounds(f.target.index));
      }
    }
    const dvec3 extent = region_.box.hi - region_.box.lo;
    region_.center = (region_.box.lo + region_.box.hi) * 0.5;
    region_.pad = 1e-6 * std::max({extent.x, extent.y, extent.z});
    region_.box.lo -= region_.pad;
    region_.box.hi += region_.pad;
  }

  /// Puts it last.
  void find_companion() {
    const auto together = [](const Boxed& b) { return b.target.targets->nearest_together != nullptr; };
    if (std::count_if(few_.begin(), few_.end(), together) != 1) return;
    const auto it = std::find_if(few_.begin(), few_.end(), together);
    std::rotate(it, it + 1, few_.end());
    companion_ = {few_.back().target.targets, few_.back().target.index};
    companion_only_ = few_.size() == 1 && lone_.empty();
  }

  /// Asks those whose boxes the ray meets, the nearest box first.
  void ask_few(RayQuery& query) const {
    struct Met {
      double t;
      const Lone* target;
    };
    std::array<Met, few_objects> met;
    std::size_t count = 0;
    const bool put_off = query.later != nullptr && companion_.targets != nullptr;
    const dvec3 inverse = 1.0 / query.ray.d;
    for (const Boxed& boxed : std::span(few_).first(few_.size() - (put_off ? 1 : 0))) {
      double t_from = query.t_from;
      double t_to = query.t_to;
      if (!BoxTree::clip(boxed.box, query.ray.o, inverse, t_from, t_to)) continue;
      std::size_t at = count++;
      for (; at > 0 && t_from < met[at - 1].t; --at) met[at] = met[at - 1];
      met[at] = {t_from, &boxed.target};
    }
    for (std::size_t i = 0; i < count && met[i].t <= query.t_to; ++i) {
      met[i].target->targets->nearest(*met[i].target->targets, met[i].target->index, query);
      if (query.any && query.found.store != nullptr) return;
    }
  }

  void attach(Member& member) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, member.targets->size());
    rtcSetGeometryUserData(geometry, &member);
    rtcSetGeometryBoundsFunction(
        geometry, [](const RTCBoundsFunctionArguments* args) { bounds_callback(args); }, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect_callback);
    rtcSetGeometryOccludedFunction(geometry, occluded_callback);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
  }

  /// Makes Embree's ray: it begins where ours enters the box of the scene, so that single precision
  /// is spent on the scene and not on the way there. False if the ray misses that box.
  bool prepare(RayQuery& query, Travelling& context, RTCRay& ray) const {
    double t_from = query.t_from;
    double t_to = query.t_to;
    if (!BoxTree::clip(region_.box, query.ray.o, 1.0 / query.ray.d, t_from, t_to)) return false;
    init_context(context);
    context.query = &query;
    context.t_start = t_from;
    const dvec3 o = query.ray.at(t_from) - region_.center;
    ray.org_x = static_cast<float>(o.x);
    ray.org_y = static_cast<float>(o.y);
    ray.org_z = static_cast<float>(o.z);
    ray.dir_x = static_cast<float>(query.ray.d.x);
    ray.dir_y = static_cast<float>(query.ray.d.y);
    ray.dir_z = static_cast<float>(query.ray.d.z);
    ray.tnear = 0;
    ray.tfar = depth_above(t_to - t_from);
    ray.time = 0;
    ray.mask = 0xFFFFFFFF;
    ray.id = 0;
    ray.flags = 0;
    return true;
  }

  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  std::vector<Member> members_;
  std::vector<Lone> lone_;  // asked one by one
  std::vector<Boxed> few_;  // all others, if they are so few that boxes of our own are faster
  Region region_;
};

}  // namespace

std::unique_ptr<Accel> make_embree_accel(std::span<const Targets* const> all) {
  return std::make_unique<EmbreeAccel>(all);
}

}  // namespace durer::tracer
