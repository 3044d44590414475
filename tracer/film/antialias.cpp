#include "tracer/film/antialias.h"

#include <algorithm>

namespace durer::tracer {

void Antialias::start(const Block& block) {
  left_ = block.left - 1;
  top_ = block.top - 1;
  stride_ = block.right - left_;
  cells_.assign(static_cast<std::size_t>(stride_) * (block.bottom - top_), Cell{});
}

Sampled Comparison::sampled(const Pixel& value) const {
  Sampled s{value, value};
  for (int i = 0; i < 3; ++i) {
    const float light = std::max(0.0F, working_.decode(value[i]));
    s.metric[i] = std::pow(light, 1 / gamma_);
  }
  return s;
}

bool Comparison::differ(const Sampled& a, const Sampled& b) const {
  const Pixel d = a.metric - b.metric;
  const float distance = std::abs(d.x) + std::abs(d.y) + std::abs(d.z) + std::abs(d.w);
  return distance >= threshold_;
}

}  // namespace durer::tracer
