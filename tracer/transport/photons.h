// Photons of a scene once they are shot (participating-and-global §3).
#pragma once

#include "tracer/transport/photon_map.h"

namespace durer::tracer {

/// All photons, and how they are gathered. Immutable while the picture is made.
struct PhotonMaps {
  PhotonMap surfaces;
  PhotonMap media;
  PhotonGathering on_surfaces;
  PhotonGathering in_media;
};

}  // namespace durer::tracer
