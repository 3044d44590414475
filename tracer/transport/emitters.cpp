#include "tracer/transport/emitters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tracer/compiled_scene.h"

namespace durer::tracer {
namespace {

constexpr double pi = std::numbers::pi;

// The faces of a box that directions from a point are chosen by: those that look at it, through each
// of which such a direction enters, or all of them when the point is inside.
class Faces {
 public:
  Faces(const Bounds3& box, dvec3 from) : box_(&box), from_(from), inside_(box.contains(from)) {
    const dvec3 edge = box.hi - box.lo;
    for (int axis = 0; axis < 3; ++axis) {
      const double area = edge[(axis + 1) % 3] * edge[(axis + 2) % 3];
      const bool low = inside_ || from[axis] < box.lo[axis];
      const bool high = inside_ || from[axis] > box.hi[axis];
      area_[static_cast<std::size_t>(2 * axis)] = low ? area : 0;
      area_[static_cast<std::size_t>(2 * axis + 1)] = high ? area : 0;
    }
    for (const double a : area_) total_ += a;
  }

  [[nodiscard]] double area() const { return total_; }

  /// Uniform on the area of the faces.
  [[nodiscard]] dvec3 direction(double pick, dvec2 u) const {
    double rest = pick * total_;
    int face = 0;
    while (face < 5 && (rest >= area_[static_cast<std::size_t>(face)])) {
      rest -= area_[static_cast<std::size_t>(face++)];
    }
    while (face > 0 && area_[static_cast<std::size_t>(face)] == 0) --face;
    const int axis = face / 2;
    dvec3 p;
    p[axis] = face % 2 == 0 ? box_->lo[axis] : box_->hi[axis];
    const auto between = [&](int i, double t) {
      p[i] = box_->lo[i] + t * (box_->hi[i] - box_->lo[i]);
    };
    between((axis + 1) % 3, u.x);
    between((axis + 2) % 3, u.y);
    const dvec3 way = p - from_;
    const double length = glm::length(way);
    return length > 0 ? way / length : dvec3(0.0);
  }

  /// Per steradian.
  [[nodiscard]] double density(dvec3 d) const {
    double enter = -INFINITY;
    double leave = INFINITY;
    int enter_axis = 0;
    int leave_axis = 0;
    for (int i = 0; i < 3; ++i) {
      if (d[i] == 0) {
        if (from_[i] < box_->lo[i] || from_[i] > box_->hi[i]) return 0;
        continue;
      }
      double near = (box_->lo[i] - from_[i]) / d[i];
      double far = (box_->hi[i] - from_[i]) / d[i];
      if (near > far) std::swap(near, far);
      if (near > enter) {
        enter = near;
        enter_axis = i;
      }
      if (far < leave) {
        leave = far;
        leave_axis = i;
      }
    }
    const double t = inside_ ? leave : enter;
    if (!(t > 0) || enter > leave || total_ == 0) return 0;
    return t * t / (std::abs(d[inside_ ? leave_axis : enter_axis]) * total_);
  }

 private:
  const Bounds3* box_;
  dvec3 from_;
  bool inside_;
  std::array<double, 6> area_{};
  double total_ = 0;
};

// Radiance times steradians, roughly: a box that the point is near, or in, does not count for more
// than all directions.
double power_of(const Emitters::Box& box, const Faces& faces, dvec3 from) {
  if (faces.area() == 0) return 0;
  const dvec3 way = (box.bounds.lo + box.bounds.hi) / 2.0 - from;
  return box.light * faces.area() / (glm::dot(way, way) + faces.area() / (4 * pi));
}

}  // namespace

BrightSky::BrightSky(std::vector<double> brightness, int columns, int rows)
    : columns_(columns), rows_(rows), sums_(std::move(brightness)) {
  for (int row = 0; row < rows_; ++row) {
    const double size = 2 * pi / columns_ *
                        (std::cos(pi * row / rows_) - std::cos(pi * (row + 1) / rows_));
    for (int column = 0; column < columns_; ++column) {
      double& cell = sums_[static_cast<std::size_t>(row * columns_ + column)];
      power_ += cell * size;
      cell = power_;
    }
  }
}

dvec3 BrightSky::direction(double column, double row, int columns, int rows) {
  const double up = std::cos(pi * row / rows);
  const double out = std::sqrt(std::max(0.0, 1 - up * up));
  const double phi = 2 * pi * column / columns;
  return {out * std::cos(phi), up, out * std::sin(phi)};
}

double BrightSky::cell_density(std::size_t cell) const {
  const int row = static_cast<int>(cell) / columns_;
  const double size = 2 * pi / columns_ *
                      (std::cos(pi * row / rows_) - std::cos(pi * (row + 1) / rows_));
  return (sums_[cell] - (cell > 0 ? sums_[cell - 1] : 0)) / (power_ * size);
}

// Uniform, by solid angle, in a cell that is chosen by its power.
Aim BrightSky::aim(dvec2 u) const {
  const double wanted = u.x * power_;
  const auto found = std::upper_bound(sums_.begin(), sums_.end() - 1, wanted);
  const auto cell = static_cast<std::size_t>(found - sums_.begin());
  const double before = cell > 0 ? sums_[cell - 1] : 0;
  const double own = sums_[cell] - before;
  if (!(own > 0)) return {};
  const int row = static_cast<int>(cell) / columns_;
  const int column = static_cast<int>(cell) % columns_;
  const double share = std::clamp((wanted - before) / own, 0.0, 1.0);
  const double top = std::cos(pi * row / rows_);
  const double bottom = std::cos(pi * (row + 1) / rows_);
  const double up = top + u.y * (bottom - top);
  const double out = std::sqrt(std::max(0.0, 1 - up * up));
  const double phi = 2 * pi * (column + share) / columns_;
  return {{out * std::cos(phi), up, out * std::sin(phi)}, cell_density(cell)};
}

double BrightSky::density(dvec3 d) const {
  if (power_ == 0) return 0;
  const double phi = std::atan2(d.z, d.x);
  const int column = static_cast<int>((phi < 0 ? phi + 2 * pi : phi) / (2 * pi) * columns_);
  const int row = static_cast<int>(std::acos(std::clamp(d.y, -1.0, 1.0)) / pi * rows_);
  return cell_density(static_cast<std::size_t>(std::min(row, rows_ - 1) * columns_ +
                                               std::min(column, columns_ - 1)));
}

namespace {

// Joins boxes until no more than `most` are left: halves of the longest side, by their middles.
void join(std::vector<Emitters::Box>::iterator first, std::vector<Emitters::Box>::iterator end,
          std::size_t most, std::vector<Emitters::Box>& out) {
  const auto count = static_cast<std::size_t>(end - first);
  if (count <= most) {
    out.insert(out.end(), first, end);
    return;
  }
  Bounds3 all;
  double light = 0;
  for (auto i = first; i != end; ++i) {
    all.add(i->bounds);
    light = std::max(light, i->light);
  }
  if (most == 1) {
    out.push_back({all, light});
    return;
  }
  const dvec3 edge = all.hi - all.lo;
  const int axis = edge.x >= edge.y && edge.x >= edge.z ? 0 : edge.y >= edge.z ? 1 : 2;
  const auto middle = first + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(first, middle, end, [axis](const Emitters::Box& a, const Emitters::Box& b) {
    return a.bounds.lo[axis] + a.bounds.hi[axis] < b.bounds.lo[axis] + b.bounds.hi[axis];
  });
  join(first, middle, most / 2, out);
  join(middle, end, most - most / 2, out);
}

}  // namespace

Emitters::Emitters(std::vector<Box> boxes, BrightSky sky) : sky_(std::move(sky)) {
  constexpr std::size_t most = 32;
  join(boxes.begin(), boxes.end(), most, boxes_);
}

// Indoors the sky is seen through windows only: it is not looked for more often than all else.
double Emitters::with_sky(double boxes) const {
  return boxes + (boxes > 0 ? std::min(boxes, sky_.power()) : sky_.power());
}

Aim Emitters::aim(dvec3 from, double pick, dvec2 u) const {
  double all = 0;
  for (const Box& box : boxes_) all += power_of(box, Faces(box.bounds, from), from);
  all = with_sky(all);
  if (!(all > 0)) return {};
  double rest = pick * all;
  Aim found;
  for (const Box& box : boxes_) {
    const Faces faces(box.bounds, from);
    const double own = power_of(box, faces, from);
    if (rest < own) {
      found.d = faces.direction(rest / own, u);
      found.density = density(from, found.d);
      return found;
    }
    rest -= own;
  }
  if (sky_.power() == 0) return {};
  found = sky_.aim(u);
  if (found.density > 0) found.density = density(from, found.d);
  return found;
}

double Emitters::density(dvec3 from, dvec3 d) const {
  double all = 0;
  double sum = 0;
  for (const Box& box : boxes_) {
    const Faces faces(box.bounds, from);
    const double own = power_of(box, faces, from);
    if (own == 0) continue;
    all += own;
    sum += own * faces.density(d);
  }
  const double boxes = all;
  all = with_sky(boxes);
  if (all > boxes) sum += (all - boxes) * sky_.density(d);
  return all > 0 ? sum / all : 0;
}

namespace {

// What a texture sends out by itself, at its brightest layer, at one place.
double glow_of(const CompiledScene& scene, ProgramId id, dvec3 p) {
  if (id == program_of_placement) return 0;
  const TextureProgram& texture = scene.textures.program(id);
  double most = 0;
  if (texture.patterned()) {
    for (const TextureChoiceEntry& e : scene.textures.entries(scene.textures.choice(texture))) {
      most = std::max(most, glow_of(scene, e.texture, p));
    }
    return most;
  }
  for (std::uint32_t i = texture.first_layer; i < texture.end_layer; ++i) {
    const LayerProgram& layer = scene.textures.layer(i);
    const vec3 glow = scene.textures.finish(layer).glow_pigment;
    if (glow == vec3(0.0F)) continue;
    const SurfaceView seen{p, {0, 0, 1}, {0, 0, -1}, {0, 0, 0}};
    const vec3 pigment = scene.textures.pigments().at(layer.pigment, p, &seen).rgb;
    // A pattern may be darker here than elsewhere.
    constexpr float least = 0.1F;
    const float here = std::abs(grey(pigment * glow));
    most = std::max(most, static_cast<double>(std::max(here, least * std::abs(grey(glow)))));
  }
  return most;
}

double glow_of(const CompiledScene& scene, const SurfaceProgram& surface, const Leaf& leaf, dvec3 p) {
  double most = std::max(glow_of(scene, surface.outside, p), glow_of(scene, surface.inside, p));
  if (!surface.has_parts) return most;
  const std::size_t parts = scene.geometry.surfaces()[leaf.surface].part_textures->size();
  for (std::size_t i = 0; i < parts; ++i) {
    most = std::max(most, glow_of(scene, scene.part_textures[surface.first_part + i], p));
  }
  return most;
}

// A sky that looks much the same all over is found as well without looking for it.
BrightSky find_bright_sky(const CompiledScene& scene) {
  constexpr int columns = 128;
  constexpr int rows = 64;
  constexpr double uneven = 2;
  std::vector<double> cells;
  double sum = 0;
  double most = 0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const dvec3 d = BrightSky::direction(column + 0.5, row + 0.5, columns, rows);
      cells.push_back(std::abs(grey(scene.sky.at(d, true).colour)));
      sum += cells.back();
      most = std::max(most, cells.back());
    }
  }
  const double mean = sum / (columns * rows);
  if (!(most > uneven * mean)) return {};
  // Something small between the middles of the cells may be bright.
  for (double& c : cells) c += 0.05 * mean;
  return BrightSky(std::move(cells), columns, rows);
}

}  // namespace

Emitters find_emitters(const CompiledScene& scene) {
  std::vector<Emitters::Box> boxes;
  scene.geometry.for_surfaces([&](const Leaf& leaf, const Bounds3& bounds) {
    if (bounds.empty() || bounds.infinite()) return;
    const dvec3 middle = (bounds.lo + bounds.hi) / 2.0;
    const double light = glow_of(scene, scene.surfaces[leaf.surface], leaf, middle);
    if (light > 0) boxes.push_back({bounds, light});
  });
  return {std::move(boxes), find_bright_sky(scene)};
}

}  // namespace durer::tracer
