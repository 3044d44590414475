// Every pattern keeps its own evidence, and its description fits its struct.
#include "tracer/patterns/patterns.h"

#include "tests/unit/tracer_shading/shading_test.h"
#include "tests/support/scene_builder.h"
#include "tracer/compile.h"
#include "tracer/shading/pigment.h"

using namespace durer;
using namespace durer::test;
using namespace durer::tracer;

namespace {

double value_of(const PatternType& type, const std::vector<double>& args, dvec3 p) {
  static const std::vector<functions::WaveSource> waves = functions::wave_sources(10);
  PatternContext context;
  context.waves = waves;
  PatternState state;
  type.prepare(args, context, state);
  return type.evaluate(state, p, nullptr);
}

}  // namespace

TEST_CASE("patterns: samples hold", "[tracer][patterns]") {
  for (const PatternType* type : pattern_types()) {
    CAPTURE(type->name);
    CHECK_FALSE(type->doc.empty());
    for (const PatternSample& s : type->samples) {
      CAPTURE(s.p.x, s.p.y, s.p.z);
      CHECK(value_of(*type, default_args(*type), s.p) == Approx(s.value).margin(1e-12));
    }
  }
}

TEST_CASE("patterns: values are finite on nasty points", "[tracer][patterns]") {
  const std::vector<double> nasty{0.0,  -0.0, 1.0,  -1.0, 1e-300, 3.141592653589793,
                                  -7.5, 1e17, -1e17};
  for (const PatternType* type : pattern_types()) {
    CAPTURE(type->name);
    for (const double x : nasty) {
      for (const double y : nasty) {
        for (const double z : nasty) {
          const double v = value_of(*type, default_args(*type), {x, y, z});
          const bool good =
              std::isfinite(v) &&
              (type->list_size == 0 || (v >= 0 && v < type->list_size && v == std::floor(v)));
          if (!good) {
            CAPTURE(x, y, z, v);
            CHECK(good);
          }
        }
      }
    }
  }
}

TEST_CASE("patterns: values of several points are those of each, to the last bit",
          "[tracer][patterns]") {
  static const std::vector<functions::WaveSource> waves = functions::wave_sources(10);
  const std::vector<dvec3> points{{0.1, 0.2, 0.3}, {-1.5, 2.25, 7.75}, {0, 0, 0},
                                  {123.4, -56.7, 8.9}, {-3, 1e6, 0.5}, {0.7, -0.1, 0.2}};
  for (const PatternType* type : pattern_types()) {
    CAPTURE(type->name);
    PatternContext context;
    context.waves = waves;
    PatternState state;
    type->prepare(default_args(*type), context, state);
    std::vector<double> values(points.size());
    type->evaluate_all(state, points, values.data());
    for (std::size_t i = 0; i < points.size(); ++i) {
      CHECK(values[i] == type->evaluate(state, points[i], nullptr));
    }
  }
}

TEST_CASE("patterns: lists are complete and maps have keys in order", "[tracer][patterns]") {
  for (const PatternType* type : pattern_types()) {
    CAPTURE(type->name);
    const auto& map = type->default_map;
    const bool needs_none = type->averages || type->only_normal || type->only_pigment ||
                            type->only_texture;
    REQUIRE(map.empty() == needs_none);
    if (type->list_size > 0) {
      REQUIRE(map.size() == static_cast<std::size_t>(type->list_size));
      for (std::size_t i = 0; i < map.size(); ++i) CHECK(map[i].key == static_cast<float>(i));
    }
    for (std::size_t i = 1; i < map.size(); ++i) CHECK(map[i - 1].key <= map[i].key);
  }
}

TEST_CASE("patterns: the registry knows them by name, in order", "[tracer][patterns]") {
  const auto infos = registry().patterns;
  REQUIRE(infos.size() == pattern_types().size());
  for (std::size_t i = 0; i < infos.size(); ++i) CHECK(infos[i] == pattern_types()[i]);
}

TEST_CASE("patterns: values are the oracle's on a cloud of points", "[tracer][patterns][oracle]") {
  struct Row {
    const char* name;
    std::vector<double> args;
    dvec3 p;
    double value;
  };
  const std::vector<Row> rows{
#define STRIP(...) __VA_ARGS__
#define DURER_PATTERN_VALUE(name, args, x, y, z, value) {name, STRIP args, {x, y, z}, value},
#include "tests/unit/tracer_shading/pattern_values.def"
#undef DURER_PATTERN_VALUE
#undef STRIP
  };
  const test::SceneBuilder names(registry());
  for (const Row& row : rows) {
    // A map that shows the value itself, after the whole pipeline.
    scene::Pigment pigment;
    pigment.pattern.edit().type = names.pattern(row.name);
    pigment.pattern.edit().args = row.args;
    const scene::PatternInfo& info = *registry().patterns[pigment.pattern->type];
    if (pigment.pattern->args.empty()) {
      pigment.pattern.edit().args = default_args(*pattern_types()[pigment.pattern->type]);
    }
    pigment.pattern.edit().frequency = info.unwrapped ? 0 : 1;
    pigment.pattern.edit().wave = info.wave;
    pigment.entries = {{0, test::rgbft(0, 0, 0), scene::none},
                       {8, test::rgbft(8, 0, 0), scene::none}};
    PigmentStore store;
    const float value = store.at(store.add(pigment, {}), row.p).rgb.x;
    if (std::abs(value - row.value) > 2e-7 * std::max(1.0, row.value)) {
      CAPTURE(row.name, row.p.x, row.p.y, row.p.z);
      CHECK(value == Approx(row.value));
    }
  }
}
