#include "tracer/compile.h"

#include "tracer/compiled_scene.h"
#include "tracer/transport/emitters.h"
#include "tracer/patterns/patterns.h"
#include "tracer/primitives/registry.h"
#include "tracer/unsupported.h"
#include "tracer/warps/warps.h"

namespace durer::tracer {
namespace {

// Words of a finish that are meant for the interior count in plain textures only; of several
// layers, the outermost speaks.
const scene::Finish* interior_words(const scene::Scene& scene, scene::TextureId id) {
  if (id == scene::none) return nullptr;
  const scene::Texture& texture = scene.textures[id];
  return texture.layers.empty() ? nullptr : &*texture.layers.back().finish;
}

bool all_supported(const scene::Scene& scene, const Geometry& geometry, Quality quality,
                   Diagnostics& diagnostics) {
  UnsupportedReport report(scene, diagnostics, quality.path);
  const auto check = [&report](scene::TextureId id) {
    if (id != scene::none && id != texture_of_placement) report.check_texture(id);
  };
  for (const Surface& surface : geometry.surfaces()) {
    check(surface.texture.texture);
    check(surface.interior_texture.texture);
    if (surface.part_textures == nullptr) continue;
    for (const scene::TextureId id : *surface.part_textures) check(id);
  }
  for (const InteriorInstance& instance : geometry.interiors()) {
    if (instance.interior != scene::none && instance.texture != scene::none) {
      report.check_interior(instance.interior);
    }
  }
  report.check_media(scene.atmosphere);
  if (scene.sky_sphere) {
    for (const scene::Pigment& p : scene.sky_sphere->pigments) report.check_sky_pigment(p);
  }
  return !diagnostics.has_errors();
}

ProgramId add_texture(CompiledScene& out, const scene::TextureUse& use) {
  return use.texture == texture_of_placement ? program_of_placement : out.textures.add(use);
}

bool is_opaque(const CompiledScene& scene, const SurfaceProgram& surface, bool of_placements) {
  const auto opaque = [&](ProgramId id) {
    return id == program_of_placement ? of_placements : scene.textures.program(id).opaque;
  };
  return opaque(surface.outside) && opaque(surface.inside);
}

bool is_bare(const CompiledScene& scene, const SurfaceProgram& surface) {
  const auto uses_uv = [&](ProgramId id) {
    return id == program_of_placement || scene.textures.program(id).uses_uv;
  };
  return !surface.has_parts && !surface.cutaway && !surface.uv_mapping &&
         !uses_uv(surface.outside) && !uses_uv(surface.inside);
}

void compile_surfaces(CompiledScene& out) {
  std::vector<bool> opaque_parts;
  for (const Surface& s : out.geometry.surfaces()) {
    SurfaceProgram program;
    program.outside = add_texture(out, s.texture);
    program.inside = s.interior_texture.texture == scene::none
                         ? program.outside
                         : add_texture(out, s.interior_texture);
    program.double_illuminate = s.double_illuminate;
    program.uv_mapping = s.uv_mapping;
    program.lamps = s.lamps;
    program.photons = s.photons;
    program.cutaway = s.cutaway != scene::none;
    bool all_opaque = true;
    if (s.part_textures != nullptr) {
      program.has_parts = true;
      program.first_part = static_cast<std::uint32_t>(out.part_textures.size());
      for (const scene::TextureId id : *s.part_textures) {
        const ProgramId part = out.textures.add({id, s.part_transform});
        out.part_textures.push_back(part);
        all_opaque = all_opaque && out.textures.program(part).opaque;
      }
    }
    program.bare = is_bare(out, program);
    out.surfaces.push_back(program);
    opaque_parts.push_back(all_opaque);
  }
  // What takes its looks from other surfaces is as opaque as all of them, whoever they are.
  bool lenders = true;
  for (std::size_t i = 0; i < out.surfaces.size(); ++i) {
    if (!out.surfaces[i].cutaway) lenders = lenders && is_opaque(out, out.surfaces[i], false);
  }
  // Contents are opaque if they are so wherever they are placed.
  bool placements = true;
  for (const Placement& placement : out.geometry.placements()) {
    placements = placements && is_opaque(out, out.surfaces[placement.surface], true);
  }
  std::vector<bool> opaque;
  for (std::size_t i = 0; i < out.surfaces.size(); ++i) {
    if (out.surfaces[i].cutaway && !lenders) opaque_parts[i] = false;
    opaque.push_back(opaque_parts[i] && is_opaque(out, out.surfaces[i], placements));
  }
  out.geometry.set_opaque(std::move(opaque));
}

void compile_interiors(const scene::Scene& scene, CompiledScene& out) {
  const auto instances = out.geometry.interiors();
  out.interiors.reserve(instances.size());
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const scene::InteriorId id = instances[i].interior;
    const scene::Interior* interior = id == scene::none ? nullptr : &scene.interiors[id];
    out.interiors.push_back(compile_interior(interior, instances[i].hollow,
                                             interior_words(scene, instances[i].texture)));
    if (interior != nullptr && out.quality.atmosphere) {
      out.interiors.back().media = out.media.add(*interior->media, instances[i].to_world);
    }
  }
  if (out.subsurface) out.subsurface->add_interiors(out.interiors);
  if (out.quality.atmosphere) out.air_media = out.media.add(scene.atmosphere, {});
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
    out.lights[p.light].plain = false;
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

CompiledScenePtr compile(const scene::Scene& scene, Diagnostics& diagnostics, int level,
                         Integrator integrator) {
  Quality quality(level);
  quality.path = integrator == Integrator::path;
  std::optional<Geometry> geometry = Geometry::build(scene, diagnostics);
  if (!geometry || !all_supported(scene, *geometry, quality, diagnostics)) return nullptr;
  auto out = std::make_unique<CompiledScene>(scene, std::move(*geometry), quality);
  compile_surfaces(*out);
  compile_interiors(scene, *out);
  if (!compile_lights(scene, *out, diagnostics)) return nullptr;
  find_camera(scene, *out);
  if (quality.path) out->emitters = find_emitters(*out);
  return CompiledScenePtr(out.release());
}

}  // namespace durer::tracer
