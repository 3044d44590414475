#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "tracer/accel/box_tree.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/height_grid.h"

namespace durer::tracer {
namespace {

// A sheet over a grid (objects §10.11); everything below it is inside, however deep, and nothing
// that lies beside the grid is. Below the water level there is inside, but no surface.
struct HeightFieldShape {
  std::shared_ptr<const HeightGrid> grid;
  std::shared_ptr<const HeightGrid> raised;  // nowhere lower than the water
  double water = 0;                          // in grid units
  bool smooth = false;
  Transform to_world;  // from grid units

  [[nodiscard]] double bottom() const { return std::max(grid->lowest(), water) - slack; }
  [[nodiscard]] double top() const { return grid->highest() + slack; }
  [[nodiscard]] Bounds3 bounds() const {
    return {{0, bottom(), 0}, {grid->columns() + 0.0, top(), grid->rows() + 0.0}};
  }
  [[nodiscard]] Bounds3 inside_bounds() const { return Bounds3::everything(); }
  [[nodiscard]] bool contains(dvec3 p) const {
    if (!(p.x >= 0 && p.x < grid->columns() && p.z >= 0 && p.z < grid->rows())) return false;
    if (!(p.y < top())) return false;
    return p.y < raised->height_at(p.x, p.z);
  }
  /// A line that comes up through the grid, and never leaves it, comes from inside.
  [[nodiscard]] bool begins_inside(const Ray& ray) const {
    return ray.d.x == 0 && ray.d.z == 0 && ray.d.y > 0 &&
           contains({ray.o.x, bottom() - 1, ray.o.z});
  }
  // Parts: two for each cell.
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t part) const {
    const std::uint32_t cell = part / 2;
    const std::uint32_t i = cell % grid->columns();
    const std::uint32_t j = cell / grid->columns();
    if (!smooth) return grid->facet_normal(i, j, part % 2 != 0);
    // The oracle mixes the normals as they are in the world.
    const auto in_world = [&](std::uint32_t x, std::uint32_t z) {
      return glm::normalize(to_world.normal(grid->vertex_normal(x, z)));
    };
    const double s = p.x - i;
    const double t = p.z - j;
    const dvec3 mixed = (1 - t) * ((1 - s) * in_world(i, j) + s * in_world(i + 1, j)) +
                        t * ((1 - s) * in_world(i, j + 1) + s * in_world(i + 1, j + 1));
    return to_world.forward.covector(mixed);
  }

  void crossings(const Ray& ray, Crossings& out) const {
    Walk walk{*this, *raised, ray, begins_inside(ray) ? Side3::below : Side3::above};
    walk.run(-no_hit_depth, no_hit_depth, [&](const Crossing& c) {
      out.push_back(c);
      return true;
    });
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    std::optional<Nearest> best;
    Walk walk{*this, *grid, ray, Side3::unknown};
    walk.run(t_from, t_to, [&](const Crossing& c) {
      if (!c.visible || !(c.t >= t_from)) return true;
      if (c.t < t_to) best = Nearest{c.t, c.part};
      return false;
    });
    return best;
  }

 private:
  static constexpr double slack = 1e-3;
  enum class Side3 : std::uint8_t { unknown, above, below };

  /// One way of a line over the grid. It knows on which side of the surface it is, and a crossing
  /// is where that changes: there is none too many or too few where cells meet.
  struct Walk {
    const HeightFieldShape& shape;
    const HeightGrid& grid;
    const Ray& ray;
    Side3 side;
    bool at_wall = false;  // nothing of the grid has been seen yet: what begins is no surface

    [[nodiscard]] double y(double t) const { return ray.o.y + t * ray.d.y; }

    /// On the side `now` from t on; false if f has had enough.
    template <typename F>
    bool turn(Side3 now, double t, std::uint32_t part, bool visible, F& f) {
      if (now == side) return true;
      const bool known = side != Side3::unknown;
      side = now;
      if (!known) return true;
      const bool seen = visible && y(t) >= shape.bottom();
      return f(Crossing{t, 0, part, now == Side3::below ? Side::enter : Side::exit, seen});
    }

    template <typename F>
    void run(double t_from, double t_to, F&& f) {
      const bool whole = side != Side3::unknown;  // the sides of the body count, too
      double t_in = t_from;
      double t_out = t_to;
      const dvec3 corner(grid.columns(), std::numeric_limits<double>::max(), grid.rows());
      if (!BoxTree::clip({{0, -corner.y, 0}, corner}, ray.o, 1.0 / ray.d, t_in, t_out)) return;
      double from = t_in;
      double to = t_out;
      const double low = grid.lowest() - 1;
      const double high = grid.highest() + 1;
      if (ray.d.y != 0) {
        const double t1 = (low - ray.o.y) / ray.d.y;
        const double t2 = (high - ray.o.y) / ray.d.y;
        from = std::max(from, std::min(t1, t2));
        to = std::min(to, std::max(t1, t2));
      } else if (ray.o.y < low || ray.o.y > high) {
        to = from;
      }
      if (!(from < to)) {
        if (!whole) return;
        const Side3 now = y(0.5 * (t_in + t_out)) < low ? Side3::below : Side3::above;
        if (turn(now, t_in, 0, false, f)) turn(Side3::above, t_out, 0, false, f);
        return;
      }
      if (whole && from > t_in &&
          !turn(ray.d.y > 0 ? Side3::below : Side3::above, t_in, 0, false, f))
        return;
      at_wall = !(from > t_in);
      bool on = true;
      grid.walk(
          ray, from, to,
          [&](std::uint32_t i, std::uint32_t j, double a, double b) {
            return on = cell(i, j, a, b, f);
          },
          [&](double t, bool below) {
            const bool seen = seen_any();
            const Side3 now = below ? Side3::below : Side3::above;
            return on = now == side || turn(now, t, part_at(t), seen, f);
          });
      if (on && whole) turn(Side3::above, t_out, 0, false, f);
    }

    /// False once, where the line comes in through a wall.
    bool seen_any() { return !std::exchange(at_wall, false); }

    [[nodiscard]] std::uint32_t part_at(double t) const {
      const dvec3 p = ray.at(t);
      const auto i = static_cast<std::uint32_t>(std::clamp(p.x, 0.0, grid.columns() - 1.0));
      const auto j = static_cast<std::uint32_t>(std::clamp(p.z, 0.0, grid.rows() - 1.0));
      return 2 * (j * grid.columns() + i);
    }

    /// Both halves of a cell, in the order in which the line comes to them.
    template <typename F>
    bool cell(std::uint32_t i, std::uint32_t j, double a, double b, F& f) {
      const double across = ray.d.x + ray.d.z;
      const double ahead = i + j + 1.0 - ray.o.x - ray.o.z;
      const double diagonal = ahead / across;
      if (across == 0) return half(i, j, ahead <= 0, a, b, f);
      if (!(diagonal > a)) return half(i, j, across > 0, a, b, f);
      if (!(diagonal < b)) return half(i, j, across < 0, a, b, f);
      return half(i, j, across < 0, a, diagonal, f) && half(i, j, across > 0, diagonal, b, f);
    }

    template <typename F>
    bool half(std::uint32_t i, std::uint32_t j, bool far, double a, double b, F& f) {
      const dvec3 n = grid.facet_normal(i, j, far);
      const dvec3 corner =
          far ? dvec3(i + 1.0, grid.height(i + 1, j + 1), j + 1.0) : dvec3(i, grid.height(i, j), j);
      const double over_a = glm::dot(ray.at(a) - corner, n);
      const double over_b = glm::dot(ray.at(b) - corner, n);
      const std::uint32_t part = 2 * (j * grid.columns() + i) + (far ? 1 : 0);
      const Side3 side_a = over_a < 0 ? Side3::below : Side3::above;
      const Side3 side_b = over_b < 0 ? Side3::below : Side3::above;
      if (!turn(side_a, a, part, seen_any(), f)) return false;
      if (side_a == side_b) return true;
      return turn(side_b, a + (b - a) * (over_a / (over_a - over_b)), part, true, f);
    }
  };
};

enum : std::size_t { water_at, smooth_at };

constexpr std::array height_field_params = {
    scene::Param{"water_level", scene::ArgKind::number, "what is lower is not seen, 0 to 1"},
    scene::Param{"smooth", scene::ArgKind::number, "1: shading hides the triangles"}};

std::optional<ShapeRef> place_height_field(TypeStores& stores, const scene::Object& object,
                                           const Surroundings&,
                                           const Transform& to_world, bool inverted) {
  const std::shared_ptr<const scene::HeightField>& field = object.extras->heights;
  if (field->width < 2 || field->height < 2) return std::nullopt;
  HeightFieldShape shape;
  shape.grid = shared_height_grid(field);
  shape.water = 65536 * object.args[water_at];
  const auto least = static_cast<std::uint16_t>(std::clamp(std::round(shape.water), 0.0, 65535.0));
  shape.raised = least > shape.grid->lowest() ? raised_height_grid(*field, least) : shape.grid;
  shape.smooth = object.args[smooth_at] != 0;
  const dvec3 unit(1.0 / shape.grid->columns(), 1.0 / 65536, 1.0 / shape.grid->rows());
  shape.to_world = Transform::scale(unit).then(to_world);
  const Transform placement = shape.to_world;
  return place_shape(stores, std::move(shape), placement, inverted);
}

scene::Object sample(bool smooth) {
  auto field = std::make_shared<scene::HeightField>();
  field->width = 9;
  field->height = 7;
  for (std::uint32_t k = 0; k < 63; ++k)
    field->heights.push_back(static_cast<std::uint16_t>(k * k * 7919 % 50000));
  scene::Object object;
  object.args = std::vector<double>{0, smooth ? 1.0 : 0.0};
  object.extras.edit().heights = std::move(field);
  return object;
}

constexpr PrimitiveType describe_height_field() {
  PrimitiveType type;
  type.name = "height_field";
  type.doc = "A landscape over a picture or function.";
  type.params = height_field_params;
  type.sides_by_order = true;  // smooth normals may look away
  type.make_stores = [] { return make_type_stores<HeightFieldShape>(); };
  type.place = [](TypeStores&, std::span<const double>, const Transform&,
                  bool) -> std::optional<ShapeRef> { return std::nullopt; };
  type.place_whole = place_height_field;
  type.samples = [] { return std::vector<std::vector<double>>{}; };
  type.sample_objects = [] { return std::vector{sample(false), sample(true)}; };
  return type;
}

}  // namespace

extern constinit const PrimitiveType height_field_primitive = describe_height_field();

}  // namespace durer::tracer
