#include "tracer/film/antialias.h"

#include <algorithm>

namespace durer::tracer {

void Antialias::start(const Block& block) {
  left_ = block.left - 1;
  top_ = block.top - 1;
  stride_ = block.right - left_;
  cells_.assign(static_cast<std::size_t>(stride_) * (block.bottom - top_), Cell{});
}

void Antialias::set(Cell& c, const Pixel& value) const {
  c.value = value;
  for (int i = 0; i < 3; ++i) {
    const float light = std::max(0.0F, options_.working.decode(value[i]));
    c.metric[i] = std::pow(light, 1 / options_.gamma);
  }
  c.metric.w = value.w;
}

bool Antialias::differ(const Cell& a, const Cell& b) const {
  const Pixel d = a.metric - b.metric;
  const float distance = std::abs(d.x) + std::abs(d.y) + std::abs(d.z) + std::abs(d.w);
  return distance >= options_.threshold;
}

}  // namespace durer::tracer
