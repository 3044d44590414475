// What a Geometry holds. Built once (geometry_build.cpp), then only read.
#pragma once

#include <atomic>
#include <mutex>

#include <memory>
#include <vector>

#include "tracer/accel/accel.h"
#include "tracer/accel/box_tree.h"
#include "tracer/csg/solid_targets.h"
#include "tracer/flatten.h"
#include "tracer/geometry.h"
#include "tracer/primitives/describe.h"

namespace durer::tracer {

/// An object of the scene as `containing` needs it: a lone primitive, or a solid.
struct Body {
  const Store* store = nullptr;  // null: a solid
  std::uint32_t index = 0;       // shape, or index into Parts::solids
  std::uint32_t interior = 0;
  bool inverted = false;
};

struct Geometry::State {
  std::vector<Leaf> leaves;
  std::vector<std::uint8_t> leaf_inverted;  // normals are negated
  std::vector<Surface> surfaces;
  std::vector<InteriorInstance> interiors;
  std::vector<scene::Light> lights;
  std::vector<std::vector<std::uint32_t>> lamp_sets;
  std::vector<Projection> projections;

  std::vector<TypeStores> lone;      // per primitive type: those that stand alone …
  std::vector<TypeStores> operands;  // … and those inside solids, clips and bounds
  Surroundings around;
  Parts parts;
  std::unique_ptr<SolidTargets> solids;
  std::unique_ptr<Accel> accel;

  std::vector<Body> bodies;  // in order of declaration
  /// Where bodies are, for those who ask often: most scenes ask once, where their camera is, and
  /// are better off without. Made on demand by index_bodies().
  struct Index {
    BoxTree boxes;  // of the bodies that are finite …
    std::vector<std::uint32_t> body_of_box;
    std::vector<std::uint32_t> endless;  // … and the others
  };
  mutable std::atomic<int> questions{0};
  mutable std::once_flag index_made;
  mutable Index index;
  mutable std::once_flag casters_found;
  mutable CasterIndex casters;  // made when somebody asks for it
  bool translucent_shadows = true;

  State(Flat flat, Hierarchy hierarchy);
  [[nodiscard]] bool body_contains(const Body& body, dvec3 p, SweepState& sweep) const;
  /// Thread-safe; does nothing the second time.
  void index_bodies() const;
  void index_casters() const;
  void set_opaque(const std::vector<bool>& by_surface);

 private:
  [[nodiscard]] std::vector<const Targets*> all_targets() const;
  void build_accel(Hierarchy hierarchy);
  void add_gates(const Flat& flat);
  void add_entry(const Flat& flat, const FlatEntry& entry);
  std::optional<ShapeRef> place(std::vector<TypeStores>& stores, const FlatLeaf& part);
};

}  // namespace durer::tracer
