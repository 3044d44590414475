#include "tracer/primitives/describe.h"
#include "tracer/primitives/facet.h"

namespace durer::tracer {
namespace {

struct SmoothFacet : Facet<SmoothFacet> {
  dvec3 na{0.0};  // unit
  dvec3 nb{0.0};
  dvec3 nc{0.0};

  /// The oracle does not show a facet whose normals point to different sides, or along it.
  [[nodiscard]] bool one_sided() const {
    const dvec3 n = corners.normal();
    const double a = glm::dot(na, n);
    const double b = glm::dot(nb, n);
    const double c = glm::dot(nc, n);
    return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
  }
  // Normals are moved, then mixed; a mesh mixes first (objects §11.3).
  [[nodiscard]] std::optional<SmoothFacet> moved(const Transform& t) const {
    const auto turned = [&](dvec3 n) { return glm::normalize(t.normal(n)); };
    return SmoothFacet{{corners.moved(t)}, turned(na), turned(nb), turned(nc)};
  }
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t /*part*/) const {
    const dvec3 w = corners.weights(p);
    return w.x * na + w.y * nb + w.z * nc;
  }
};

// A triangle that is shaded as if it were curved (objects §11.3).
struct SmoothTriangle {
  dvec3 a{0.0};
  dvec3 na{0, 1, 0};
  dvec3 b{0.0};
  dvec3 nb{0, 1, 0};
  dvec3 c{0.0};
  dvec3 nc{0, 1, 0};

  static constexpr std::array params{
      positional<&SmoothTriangle::a>("corner", "first corner"),
      positional<&SmoothTriangle::na>("normal", "normal at the first corner, any length"),
      positional<&SmoothTriangle::b>("corner", "second corner"),
      positional<&SmoothTriangle::nb>("normal", "normal at the second corner"),
      positional<&SmoothTriangle::c>("corner", "third corner"),
      positional<&SmoothTriangle::nc>("normal", "normal at the third corner"),
  };
  static std::vector<SmoothTriangle> samples() {
    return {{{0, 0, 0}, {-1, 0, -2}, {1, 0, 0}, {1, 0, -2}, {0, 1, 0}, {0, 1, -1}},
            {{-1, -1, 2}, {0, 0, -1}, {3, 0, 1}, {0.5, 0, -3}, {0.5, 2, -1}, {0, 0.2, -1}}};
  }
  [[nodiscard]] std::optional<std::string> doubt() const {
    const dvec3 none(0.0);
    if (na == none || nb == none || nc == none) return "a facet without a normal is not visible";
    const SmoothFacet facet{{{a, b, c}}, na, nb, nc};
    if (facet.corners.normal() == none) return "a triangle without area is not visible";
    if (!facet.one_sided()) return "its normals point to different sides: it is not visible";
    return std::nullopt;
  }
  [[nodiscard]] std::optional<Framed<SmoothFacet>> shape() const {
    if (doubt()) return std::nullopt;
    return Framed<SmoothFacet>{
        {{{a, b, c}}, glm::normalize(na), glm::normalize(nb), glm::normalize(nc)}, {}};
  }
};

}  // namespace

extern constinit const PrimitiveType smooth_triangle_primitive = patch(describe<SmoothTriangle>(
    "smooth_triangle", "A triangle with a normal at each corner, mixed in between."));

}  // namespace durer::tracer
