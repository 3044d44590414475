// The walk of several lines through the cells of a field: for field_packet.cpp.
#pragma once

#include <cstdint>

#include "tracer/primitives/field_packet.h"

namespace durer::tracer {

/// Leads `lanes` of the packet, which meet the halves of cells in the same order, from their
/// beginnings to their first visible crossings, or to their ends.
void walk_field(FieldPacket& packet, std::uint32_t lanes);

}  // namespace durer::tracer
