#include "cli/convert.h"

#include "tests/unit/cli/read.h"

namespace durer::cli {
namespace {

scene::Settings scene_with(scene::GammaMode mode, const GammaCurve& curve = {}, int version = 370) {
  scene::Settings s;
  s.gamma_mode = mode;
  s.assumed_gamma = curve;
  s.effective_version = version;
  return s;
}

}  // namespace

TEST_CASE("convert: gamma handling follows the scene's mode", "[cli][convert]") {
  using scene::GammaMode;
  const Settings plain = test::accepted({"File_Gamma=1.8"});
  const auto explicit_mode =
      encoding_of(plain, scene_with(GammaMode::explicit_, GammaCurve::power(2.2F)));
  CHECK(explicit_mode.encode);
  CHECK(explicit_mode.working == GammaCurve::power(2.2F));
  CHECK(explicit_mode.file == GammaCurve::power(1.8F));
  CHECK(encoding_of(plain, scene_with(GammaMode::legacy)).encode);
  CHECK(encoding_of(plain, scene_with(GammaMode::implied)).encode);
  CHECK_FALSE(encoding_of(plain, scene_with(GammaMode::off, {}, 362)).encode);
  CHECK_FALSE(encoding_of(test::accepted({"Version=3.6"}), scene_with(GammaMode::off)).encode);
  CHECK(encoding_of(test::accepted({"Version=3.7"}), scene_with(GammaMode::off)).encode);
}

TEST_CASE("convert: bits, alpha, greyscale and compression", "[cli][convert]") {
  const auto e = encoding_of(test::accepted({"+FN16g", "+UA", "Compression=3"}),
                             scene_with(scene::GammaMode::explicit_));
  CHECK(e.bits == 16);
  CHECK(e.greyscale);
  CHECK(e.alpha);
  CHECK(e.compression == 3);
  CHECK(encoding_of(test::accepted({"+FC"}), scene_with(scene::GammaMode::off)).compression == 1);
}

TEST_CASE("convert: sampling options reach the renderer", "[cli][convert]") {
  const auto o = render_options(
      test::accepted({"+W80", "+H60", "+A0.2", "+R4", "-J0.5", "+AG2", "+BS16", "+WT3"}),
      {1, 2, 3, 4});
  CHECK(o.width == 80);
  CHECK(o.height == 60);
  CHECK(o.antialias);
  CHECK(o.aa_threshold == 0.2F);
  CHECK(o.aa_depth == 4);
  CHECK(o.aa_jitter == 0);
  CHECK(o.aa_gamma == 2);
  CHECK(o.block_size == 16);
  CHECK(o.threads == 3);
  CHECK_FALSE(o.alpha);
  CHECK(render_options(test::accepted({"+UA"}), {}).alpha);
  CHECK(o.first_column == 1);
  CHECK(o.end_row == 4);
  CHECK_FALSE(render_options(test::accepted({"+A", "+AM0"}), {}).antialias);
}

TEST_CASE("convert: the interpreter learns what the scene can see", "[cli][convert]") {
  const Settings settings =
      test::accepted({"+La", "Declare=X=1", "+K0.1", "+MV3.5", "+UA", "+HIhead.inc"});
  const auto o = interpreter_options(settings, frame_task(settings, 0));
  CHECK(o.include_paths == std::vector<std::string>{"a"});
  CHECK(o.declares.size() == 1);
  CHECK(o.clock == static_cast<double>(0.1F));
  CHECK(o.clock_on);
  CHECK(o.frame.last == 0);
  CHECK(o.version == 350);
  CHECK(o.output_alpha);
  CHECK(o.header_file == "head.inc");
  CHECK_FALSE(o.confined);
}

TEST_CASE("convert: frames and limits reach the interpreter", "[cli][convert]") {
  const Settings settings = test::accepted({"+KFI2", "+KFF4", "+KC", "--untrusted"});
  const auto o = interpreter_options(settings, frame_task(settings, 1));
  CHECK(o.frame.number == 3);
  CHECK(o.frame.first == 2);
  CHECK(o.frame.last == 5);
  CHECK(o.frame.clock_delta == 0.333333);
  CHECK(o.clock == static_cast<double>(static_cast<float>(1.0 / 3)));
  CHECK(o.limits.macro_depth == 200);
  CHECK(o.confined);
  CHECK(o.writable.empty());
}

TEST_CASE("convert: options may change what was assumed", "[cli][convert]") {
  using scene::GammaMode;
  Settings settings;
  const std::string line = "language 3.62 (option); no assumed_gamma, colours are stored as they are";
  CHECK(assumptions(settings, scene_with(GammaMode::off, {}, 362), line) == line);
  settings.version = 370;
  CHECK(assumptions(settings, scene_with(GammaMode::explicit_), "as told") == "as told");
  CHECK(assumptions(settings, scene_with(GammaMode::off, {}, 362), line) ==
        "language 3.62 (option); no assumed_gamma, 1 is taken because of Version=3.7");
}

}  // namespace durer::cli
