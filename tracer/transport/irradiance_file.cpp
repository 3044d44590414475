#include "tracer/transport/irradiance_file.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>

namespace durer::tracer {
namespace {

// A unit vector as three bytes.
std::uint32_t packed(dvec3 n) {
  const auto byte = [](double c) {
    return static_cast<std::uint32_t>((c + 1) * 127 + 0.499999) & 0xFFU;
  };
  return byte(n.x) << 16 | byte(n.y) << 8 | byte(n.z);
}

dvec3 unpacked(std::uint32_t bits) {
  const auto component = [&](unsigned shift) { return (bits >> shift & 0xFFU) / 254.0 * 2 - 1; };
  return glm::normalize(dvec3(component(16), component(8), component(0)));
}

// Reads the fields of a line, which tabs part.
class Fields {
 public:
  explicit Fields(std::string_view line) : at_(line.data()), end_(at_ + line.size()) {}

  double number() {
    double x = 0;
    return take([&] { return std::from_chars(at_, end_, x); }) && std::isfinite(x) ? x : fail();
  }
  dvec3 point() {
    dvec3 p;
    for (int i = 0; i < 3; ++i) p[i] = number();
    return p;
  }
  dvec3 direction() {
    std::uint32_t bits = 0;
    if (!take([&] { return std::from_chars(at_, end_, bits, 16); })) fail();
    return unpacked(bits);
  }
  /// All of the line has been read, and every field was there.
  [[nodiscard]] bool good() const { return good_ && at_ == end_; }

 private:
  template <typename Read>
  bool take(const Read& read) {
    const std::from_chars_result result = read();
    at_ = result.ptr;
    if (at_ != end_ && *at_ == '\t') ++at_;
    return result.ec == std::errc();
  }
  double fail() {
    good_ = false;
    return 0;
  }

  const char* at_;
  const char* end_;
  bool good_ = true;
};

std::optional<IrradianceSample> sample_of(std::string_view line) {
  if (line.empty() || line.front() != 'C') return std::nullopt;
  Fields fields(line.substr(1));
  IrradianceSample s;
  const double bounce = fields.number();
  s.p = fields.point();
  s.n = fields.direction();
  s.light = vec3(fields.point());
  s.radius = fields.number();
  s.nearest = fields.number();
  s.to_nearest = fields.direction();
  s.quality = 1;
  if (!fields.good() || !(bounce >= 1) || bounce > IrradianceCache::max_depth) return std::nullopt;
  if (!(s.radius > 0) || !(s.nearest >= 0)) return std::nullopt;
  s.depth = static_cast<std::uint32_t>(bounce) - 1;
  return s;
}

}  // namespace

std::string encode_samples(std::span<const IrradianceSample> samples) {
  std::string text;
  for (const IrradianceSample& s : samples) {
    fmt::format_to(std::back_inserter(text),
                   "C{}\t{:g}\t{:g}\t{:g}\t{:06x}\t{:.4f}\t{:.4f}\t{:.4f}\t{:g}\t{:g}\t{:06x}\n",
                   s.depth + 1, s.p.x, s.p.y, s.p.z, packed(s.n), s.light.x, s.light.y, s.light.z,
                   s.radius, s.nearest, packed(s.to_nearest));
  }
  return text;
}

std::optional<std::vector<IrradianceSample>> decode_samples(std::string_view text) {
  std::vector<IrradianceSample> samples;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.empty()) continue;
    const auto sample = sample_of(line);
    if (!sample) return std::nullopt;
    samples.push_back(*sample);
  }
  return samples;
}

}  // namespace durer::tracer
