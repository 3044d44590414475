#include <glm/common.hpp>

#include "tracer/primitives/describe.h"
#include "tracer/primitives/facet.h"

namespace durer::tracer {
namespace {

struct FlatFacet : Facet<FlatFacet> {
  [[nodiscard]] std::optional<FlatFacet> moved(const Transform& t) const {
    if (t.is_identity()) return *this;
    return FlatFacet{{turned().moved(t)}};
  }
  /// The oracle exchanges two corners of triangles that face the wrong way along the axis they face
  /// most; it looks at the given order as long as the triangle is not moved (objects §11.2).
  [[nodiscard]] Corners turned() const {
    const dvec3 n = corners.normal();
    const dvec3 size = glm::abs(n);
    const bool wrong = size.x >= size.y && size.x >= size.z ? n.x > 0
                       : size.y >= size.z                   ? n.y < 0
                                                            : n.z > 0;
    return wrong ? Corners{corners.b, corners.a, corners.c} : corners;
  }
  [[nodiscard]] dvec3 normal(dvec3 /*p*/, std::uint32_t /*part*/) const { return corners.normal(); }
};

// One triangle (objects §11.2).
struct Triangle {
  dvec3 a{0.0};
  dvec3 b{0.0};
  dvec3 c{0.0};

  static constexpr std::array params{
      positional<&Triangle::a>("corner", "first corner"),
      positional<&Triangle::b>("corner", "second corner"),
      positional<&Triangle::c>("corner", "third corner"),
  };
  static std::vector<Triangle> samples() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{-1, -1, 2}, {3, 0, 1}, {0.5, 2, -1}}};
  }
  [[nodiscard]] std::optional<std::string> doubt() const {
    if (Corners{a, b, c}.normal() != dvec3(0.0)) return std::nullopt;
    return "a triangle without area is not visible";
  }
  [[nodiscard]] std::optional<Framed<FlatFacet>> shape() const {
    if (doubt()) return std::nullopt;
    return Framed<FlatFacet>{{{{a, b, c}}}, {}};
  }
};

}  // namespace

extern constinit const PrimitiveType triangle_primitive =
    patch(describe<Triangle>("triangle", "A flat triangle: three corners."));

}  // namespace durer::tracer
