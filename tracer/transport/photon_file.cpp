#include "tracer/transport/photon_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <glm/common.hpp>
#include <limits>
#include <memory>
#include <numbers>

namespace durer::tracer {
namespace {

constexpr std::size_t record_size = 20;
constexpr double angles_per_radian = 127 / std::numbers::pi;
constexpr int exponent_of_one = 250;

// Three numbers of 8 bits with an exponent in common; what is left is cut off.
std::array<std::uint8_t, 4> packed(vec3 c) {
  const float greatest = std::max({c.x, c.y, c.z});
  int exponent = 0;
  if (!(greatest > 0) || !std::isfinite(greatest)) return {};
  std::frexp(greatest, &exponent);
  if (exponent + exponent_of_one <= 0) return {};
  exponent = std::min(exponent, 255 - exponent_of_one);
  const auto part = [&](float x) {
    return static_cast<std::uint8_t>(std::clamp(std::ldexp(x, 8 - exponent), 0.0F, 255.0F));
  };
  return {part(c.x), part(c.y), part(c.z), static_cast<std::uint8_t>(exponent + exponent_of_one)};
}

vec3 unpacked(const std::uint8_t* c) {
  const float scale = std::ldexp(1.0F, c[3] - exponent_of_one - 8);
  return vec3(c[0], c[1], c[2]) * scale;
}

void encode(const Photon& photon, int axis, std::uint8_t* to) {
  std::memcpy(to, &photon.p, 12);
  const auto colour = packed(photon.power);
  std::copy(colour.begin(), colour.end(), to + 12);
  const auto angle = [](double radians) {
    return static_cast<std::uint8_t>(static_cast<std::int8_t>(radians * angles_per_radian));
  };
  to[16] = static_cast<std::uint8_t>(axis);
  to[17] = angle(std::asin(std::clamp(double{photon.l.y}, -1.0, 1.0)));
  to[18] = angle(std::atan2(double{photon.l.z}, double{photon.l.x}));
  to[19] = 0;
}

Photon decoded(const std::uint8_t* from) {
  Photon photon;
  std::memcpy(&photon.p, from, 12);
  photon.power = unpacked(from + 12);
  const double up = static_cast<std::int8_t>(from[17]) / angles_per_radian;
  const double around = static_cast<std::int8_t>(from[18]) / angles_per_radian;
  photon.l = vec3(std::cos(up) * std::cos(around), std::sin(up), std::cos(up) * std::sin(around));
  return photon;
}

// Puts the middle photon of the longest side between the others, and so on in both halves.
void encode_tree(std::span<Photon> photons, std::uint8_t* to) {
  while (!photons.empty()) {
    vec3 lo(std::numeric_limits<float>::infinity());
    vec3 hi = -lo;
    for (const Photon& f : photons) {
      lo = glm::min(lo, f.p);
      hi = glm::max(hi, f.p);
    }
    const vec3 side = hi - lo;
    const int axis = side.x >= side.y ? (side.x >= side.z ? 0 : 2) : (side.y >= side.z ? 1 : 2);
    const std::size_t middle = (photons.size() - 1) / 2;
    std::nth_element(photons.begin(), photons.begin() + static_cast<std::ptrdiff_t>(middle),
                     photons.end(),
                     [axis](const Photon& a, const Photon& b) { return a.p[axis] < b.p[axis]; });
    encode(photons[middle], axis, to + middle * record_size);
    encode_tree(photons.first(middle), to);
    to += (middle + 1) * record_size;
    photons = photons.subspan(middle + 1);
  }
}

void append(std::vector<Photon> photons, std::vector<std::uint8_t>& bytes) {
  const auto count = static_cast<std::uint32_t>(photons.size());
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof count + record_size * count);
  std::memcpy(&bytes[at], &count, sizeof count);
  encode_tree(photons, bytes.data() + at + sizeof count);
}

bool take(std::span<const std::uint8_t>& bytes, std::vector<Photon>& photons) {
  std::uint32_t count = 0;
  if (bytes.size() < sizeof count) return false;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes = bytes.subspan(sizeof count);
  if (bytes.size() / record_size < count) return false;
  photons.reserve(count);
  for (std::size_t i = 0; i < count; ++i) photons.push_back(decoded(&bytes[i * record_size]));
  bytes = bytes.subspan(count * record_size);
  return true;
}

}  // namespace

std::vector<std::uint8_t> encode_photons(const PhotonLists& photons) {
  std::vector<std::uint8_t> bytes;
  append(photons.surfaces, bytes);
  append(photons.media, bytes);
  return bytes;
}

std::optional<PhotonLists> decode_photons(std::span<const std::uint8_t> bytes) {
  PhotonLists lists;
  if (!take(bytes, lists.surfaces) || !take(bytes, lists.media) || !bytes.empty()) {
    return std::nullopt;
  }
  return lists;
}

std::optional<std::string> write_photons(const PhotonLists& photons, const std::string& path) {
  const std::vector<std::uint8_t> bytes = encode_photons(photons);
  const auto close = [](std::FILE* f) { std::fclose(f); };
  const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "wb"), close);
  const bool written = file && std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size() &&
                       std::fflush(file.get()) == 0;
  if (written) return std::nullopt;
  return "cannot write the photons to `" + path + "`";
}

}  // namespace durer::tracer
