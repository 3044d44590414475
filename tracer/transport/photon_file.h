// Files of photons (participating-and-global §3.14).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tracer/transport/photon_map.h"

namespace durer::tracer {

/// Photons on surfaces and in media.
struct PhotonLists {
  std::vector<Photon> surfaces;
  std::vector<Photon> media;
};

/// The bytes of a file: two lists, each a count and records of 20 bytes, in the order of a balanced
/// tree, because other readers search them as they are. Colours keep 8 bits, directions a degree or so.
[[nodiscard]] std::vector<std::uint8_t> encode_photons(const PhotonLists& photons);

/// What the bytes of a file say; nothing if they are not such a file.
[[nodiscard]] std::optional<PhotonLists> decode_photons(std::span<const std::uint8_t> bytes);

/// Writes a file; returns what went wrong, or nothing.
[[nodiscard]] std::optional<std::string> write_photons(const PhotonLists& photons,
                                                       const std::string& path);

}  // namespace durer::tracer
