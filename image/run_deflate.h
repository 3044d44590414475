// Bytes → a raw deflate stream (RFC 1951), by their frequencies and by runs of one byte alone.
#pragma once

#include <span>
#include <vector>

namespace durer::image {

/// Appends what becomes of `part`, up to a byte boundary; `last`: the stream ends there. A stream
/// may be made of such pieces and others. As small as what zlib makes of it with Z_RLE, in a fifth of
/// the time: zlib takes input in drops, and looks for runs by way of what it searches windows with.
void deflate_runs(std::span<const unsigned char> part, bool last, std::vector<unsigned char>& out);

}  // namespace durer::image
