#include "tracer/warps/turbulence.h"

namespace durer::tracer::warps {

extern constinit const WarpType turbulence_warp =
    describe_warp<Turbulence>("turbulence", "Stirs points (textures §4.2).");

}  // namespace durer::tracer::warps
