// Makes wide nodes; Embree's builder splits.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "tracer/accel/embree_api.h"
#include "tracer/accel/wide_nodes.h"

namespace durer::tracer {

/// What is built over: `primID` is the item's number.
using WideItems = std::vector<RTCBuildPrimitive>;

/// Appends an item; its box counts for the bounds. Boxes beyond the range of single precision are
/// left out: nobody could see what is in them.
void add_item(WideItems& items, const Bounds3& box, std::uint32_t number, WideNodes& nodes);

/// Turns the leaf of these items, four at most, into a number below WideNodes::leaf_mark.
using MakeLeaf = std::function<std::uint32_t(std::span<const std::uint32_t> items)>;

/// Fills `nodes`; leaves hold up to `leaf_size` items, 1 to 4. The items are used up.
/// `expect(leaves)` is told their number first.
void build_wide_nodes(WideItems items, std::size_t leaf_size, WideNodes& nodes,
                      const std::function<void(std::size_t)>& expect, const MakeLeaf& make_leaf);

}  // namespace durer::tracer
