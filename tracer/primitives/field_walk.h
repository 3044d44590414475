// The walk of several lines through the cells of a field: for field_packet.cpp.
#pragma once

#include "tracer/primitives/field_packet.h"

namespace durer::tracer {

/// Answers the rays of the packet.
void walk_field(FieldPacket& packet);

}  // namespace durer::tracer
