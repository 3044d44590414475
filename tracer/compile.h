// Scene (plain data) → compiled scene (arrays by type, hierarchy, texture programs). Public.
#pragma once

#include <memory>

#include "base/diagnostic.h"
#include "scene/scene.h"
#include "scene/type_info.h"

namespace durer::tracer {

/// All primitives and patterns this tracer can render, in the order of primitives.def and
/// patterns.def. The interpreter binds scenes against this table.
[[nodiscard]] const scene::Registry& registry();

/// Immutable, shared by all threads of a render.
struct CompiledScene;
struct DeleteCompiledScene {
  void operator()(const CompiledScene* s) const;
};
using CompiledScenePtr = std::unique_ptr<const CompiledScene, DeleteCompiledScene>;

/// How light is followed through the scene.
enum class Integrator : std::uint8_t {
  trace,  // as POV-Ray does it: mirrors and glass, lamps, radiosity where the scene asks for it
  path,   // along random paths, all light from all surfaces (docs/path-tracing.md)
};

/// Builds stores, hierarchy, CSG programs and texture programs. Whatever the scene uses that the
/// tracer cannot render is reported as an error with its origin; then the result is null.
/// `scene` must outlive the result. `quality`, 0 to 9, leaves out parts of the work below 9
/// (shading §3.6). A scene is compiled for one integrator: paths find light that the other one
/// has to assume.
[[nodiscard]] CompiledScenePtr compile(const scene::Scene& scene, Diagnostics& diagnostics,
                                       int quality = 9,
                                       Integrator integrator = Integrator::trace);

}  // namespace durer::tracer
