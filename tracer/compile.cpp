#include "tracer/compile.h"

#include "tracer/compiled_scene.h"
#include "tracer/patterns/patterns.h"
#include "tracer/primitives/registry.h"
#include "tracer/unsupported.h"
#include "tracer/warps/warps.h"

namespace durer::tracer {
namespace {

// Words of a finish that are meant for the interior count in plain textures only; of several
// layers, the outermost speaks.
const scene::Finish* interior_words(const scene::Scene& scene, const Surface& surface) {
  const scene::Texture& texture = scene.textures[surface.texture.texture];
  return texture.layers.empty() ? nullptr : &*texture.layers.back().finish;
}

bool all_supported(const scene::Scene& scene, const Geometry& geometry, Diagnostics& diagnostics) {
  UnsupportedReport report(scene, diagnostics);
  for (const Leaf& leaf : geometry.leaves()) {
    const Surface& surface = geometry.surfaces()[leaf.surface];
    report.check_texture(surface.texture.texture);
    if (surface.part_textures != nullptr) {
      for (const scene::TextureId id : *surface.part_textures) report.check_texture(id);
    }
    if (surface.interior_texture.texture != scene::none) {
      report.check_texture(surface.interior_texture.texture);
    }
    const scene::InteriorId interior = geometry.interiors()[leaf.interior].interior;
    if (interior != scene::none) report.check_interior(interior);
  }
  if (scene.sky_sphere) {
    for (const scene::Pigment& p : scene.sky_sphere->pigments) report.check_sky_pigment(p);
  }
  return !diagnostics.has_errors();
}

void compile_surfaces(CompiledScene& out) {
  std::vector<bool> opaque;
  for (const Surface& s : out.geometry.surfaces()) {
    SurfaceProgram program;
    program.outside = out.textures.add(s.texture);
    program.inside = s.interior_texture.texture == scene::none
                         ? program.outside
                         : out.textures.add(s.interior_texture);
    program.double_illuminate = s.double_illuminate;
    program.uv_mapping = s.uv_mapping;
    program.lamps = s.lamps;
    bool all_opaque = out.textures.program(program.outside).opaque &&
                      out.textures.program(program.inside).opaque;
    if (s.part_textures != nullptr) {
      program.has_parts = true;
      program.first_part = static_cast<std::uint32_t>(out.part_textures.size());
      for (const scene::TextureId id : *s.part_textures) {
        const ProgramId part = out.textures.add({id, s.part_transform});
        out.part_textures.push_back(part);
        all_opaque = all_opaque && out.textures.program(part).opaque;
      }
    }
    out.surfaces.push_back(program);
    opaque.push_back(all_opaque);
  }
  out.geometry.set_opaque(std::move(opaque));
}

void compile_interiors(const scene::Scene& scene, CompiledScene& out) {
  const auto instances = out.geometry.interiors();
  std::vector<const scene::Finish*> finishes(instances.size());
  for (const Leaf& leaf : out.geometry.leaves()) {
    finishes[leaf.interior] = interior_words(scene, out.geometry.surfaces()[leaf.surface]);
  }
  out.interiors.reserve(instances.size());
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const scene::InteriorId id = instances[i].interior;
    const scene::Interior* interior = id == scene::none ? nullptr : &scene.interiors[id];
    out.interiors.push_back(compile_interior(interior, instances[i].hollow, finishes[i]));
  }
}

bool compile_lights(const scene::Scene& scene, CompiledScene& out, Diagnostics& diagnostics) {
  for (const scene::Light& light : out.geometry.lights()) {
    out.lights.push_back(compile_light(light, out.quality.area_lights));
    out.reaches.push_back(reach_of(out.lights.back()));
  }
  for (const Projection& p : out.geometry.projections()) {
    auto alone = Geometry::build_object(scene, p.object, diagnostics, p.to_world);
    if (!alone) return false;
    out.lights[p.light].projector = static_cast<std::uint32_t>(out.projectors.size());
    out.projectors.push_back(std::move(*alone));
  }
  return true;
}

void find_camera(const scene::Scene& scene, CompiledScene& out) {
  std::vector<std::uint32_t> around;
  const GeometryScratchPtr scratch = out.geometry.make_scratch();
  out.geometry.containing(scene.camera.location, around, *scratch);
  for (const std::uint32_t id : around) out.around_camera.append(id);
}

}  // namespace

const scene::Registry& registry() {
  static const scene::Registry all{primitive_infos(), pattern_infos(), warp_infos()};
  return all;
}

void DeleteCompiledScene::operator()(const CompiledScene* s) const { delete s; }

CompiledScenePtr compile(const scene::Scene& scene, Diagnostics& diagnostics, int quality) {
  std::optional<Geometry> geometry = Geometry::build(scene, diagnostics);
  if (!geometry || !all_supported(scene, *geometry, diagnostics)) return nullptr;
  auto out = std::make_unique<CompiledScene>(scene, std::move(*geometry), Quality(quality));
  compile_surfaces(*out);
  compile_interiors(scene, *out);
  if (!compile_lights(scene, *out, diagnostics)) return nullptr;
  find_camera(scene, *out);
  return CompiledScenePtr(out.release());
}

}  // namespace durer::tracer
