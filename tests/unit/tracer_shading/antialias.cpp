// Anti-aliasing method 1 against the oracle (shading §10.8).
#include "tracer/film/antialias.h"

#include <map>

#include "tests/support/catch.h"

using namespace durer;
using namespace durer::tracer;

namespace {

struct Picture {
  std::map<std::pair<int, int>, Pixel> pixels;
  int samples = 0;
};

template <typename Function>
Picture rendered(const AntialiasOptions& options, const Block& block, const Function& f) {
  Picture picture;
  Antialias antialias(options);
  antialias.render(
      block,
      [&](std::span<const Spot> spots, Pixel* out) {
        for (const Spot& spot : spots) *out++ = f(spot.x, spot.y);
        picture.samples += static_cast<int>(spots.size());
      },
      [&](int x, int y, const Pixel& p) {
        picture.pixels[{x, y}] = p;
      });
  return picture;
}

}  // namespace

TEST_CASE("antialias: an edge gets the oracle's jittered averages", "[tracer][antialias]") {
  // 10x8 pixels of unit size around the origin.
  const auto edge = [](double x, double y) {
    const double wx = (x + 0.5) - 5;
    const double wy = 4 - (y + 0.5);
    return Pixel(0.37 * wx + 0.91 * wy >= 0.1 ? 0.85F : 0.15F);
  };
  const auto grey_edge = [&](double x, double y) {
    Pixel p = edge(x, y);
    p.w = 0;
    return p;
  };
  const Picture p = rendered({}, {0, 0, 10, 8}, grey_edge);
  const std::vector<float> row{.15F, .15F, .15F, .36F, .64F, .85F, .85F, .85F, .85F, .85F};
  for (int x = 0; x < 10; ++x) {
    CAPTURE(x);
    CHECK(p.pixels.at({x, 3}).x == Approx(row[x]).margin(1e-5));
  }
}

TEST_CASE("antialias: the threshold is taken after gamma", "[tracer][antialias]") {
  const float bright = GENERATE(0.098F, 0.105F);
  CAPTURE(bright);
  const auto step = [&](double x, double) {
    const float v = x < 2 ? 0.05F : bright;
    return Pixel(v, v, v, 0);
  };
  const Picture p = rendered({}, {0, 0, 4, 4}, step);
  const int centres = 4 * 4 + 4 + 4;
  if (bright < 0.1F) {
    CHECK(p.samples == centres);
  } else {
    CHECK(p.samples > centres);
  }
}

TEST_CASE("antialias: threshold 0 refines every pixel once", "[tracer][antialias]") {
  AntialiasOptions options;
  options.threshold = 0;
  options.depth = GENERATE(1, 2, 3, 4);
  const Picture p = rendered(options, {0, 0, 5, 3}, [](double, double) { return Pixel(0.5F); });
  CHECK(p.samples == 15 + 5 + 3 + 15 * options.depth * options.depth);
  CHECK(p.pixels.at({2, 1}).x == Approx(0.5));
}

TEST_CASE("antialias: transmittance counts as a difference", "[tracer][antialias]") {
  const auto hole = [](double x, double) { return Pixel(0, 0, 0, x < 2 ? 0 : 1); };
  const Picture p = rendered({}, {0, 0, 4, 1}, hole);
  CHECK(p.samples > 4 + 4 + 1);
}
