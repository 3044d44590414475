// Whether it is worth while to look for repetitions.
#pragma once

#include <cstddef>
#include <span>

namespace durer::image {

/// About how many bytes could be saved in `part` by naming places where the same stands before. So
/// quick that some are missed, and rather more than zlib gains: where this is little, zlib gains
/// nothing. `size`: what `part` takes without. At most 65,536 bytes.
[[nodiscard]] double repeated_bytes(std::span<const unsigned char> part, std::size_t size);

}  // namespace durer::image
