// The walk of several lines through the cells of a field: for field_packet.cpp, and for tests.
#pragma once

#include <span>

namespace durer::tracer {

class FieldPacket;

/// Answers the rays of the packet.
using FieldWalkVersion = void (*)(FieldPacket& packet);
/// One for each set of instructions that this processor has, the fastest last. All give the same
/// bits.
[[nodiscard]] std::span<const FieldWalkVersion> field_walks();

}  // namespace durer::tracer
