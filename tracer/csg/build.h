// Flat trees → solids.
#pragma once

#include <functional>
#include <optional>

#include "tracer/csg/parts.h"
#include "tracer/primitives/typed_store.h"

namespace durer::tracer {

/// Puts a part of a solid into its store; none if it has neither surface nor inside.
using PlacePart = std::function<std::optional<ShapeRef>(const FlatLeaf&)>;

/// Appends the solid below `node` to `parts` and returns its index.
std::uint32_t add_solid(Parts& parts, const Flat& flat, std::uint32_t node, const PlacePart& place);

/// Every ray that passes the gate meets this box.
[[nodiscard]] Bounds3 gate_bounds(const Parts& parts, std::uint32_t gate);

/// True if every ray that meets `box` surely passes the gate: then it need not be asked.
[[nodiscard]] bool gate_holds(const Parts& parts, std::uint32_t gate, const Bounds3& box);

}  // namespace durer::tracer
