# Shapes, CSG and hierarchy: durer::geometry.
durer_entries(primitive_sources primitives/primitives.def primitives)
add_library(durer_geometry STATIC
  extent.cpp
  flatten.cpp
  geometry.cpp
  geometry_build.cpp
  geometry_together.cpp
  object_queries.cpp
  placements.cpp
  sharing.cpp
  accel/box_tree.cpp
  accel/casters.cpp
  accel/embree.cpp
  accel/linear.cpp
  accel/triangle_build.cpp
  accel/triangle_tree.cpp
  accel/wide_build.cpp
  csg/build.cpp
  csg/cutaway.cpp
  csg/gate.cpp
  csg/solid_targets.cpp
  csg/sweep.cpp
  primitives/field_packet.cpp
  primitives/field_search.cpp
  primitives/field_walk.cpp
  primitives/function_field.cpp
  primitives/isosurface_shape.cpp
  primitives/mesh_shape.cpp
  primitives/parametric_shape.cpp
  primitives/blob_field.cpp
  primitives/blob_line.cpp
  primitives/height_grid.cpp
  primitives/julia_set.cpp primitives/julia_lanes.cpp
  primitives/mesh_shape.cpp
  primitives/outline.cpp
  primitives/packet.cpp
  primitives/profile.cpp
  primitives/registry.cpp
  primitives/sampled_search.cpp
  primitives/tube.cpp
  primitives/typed_store.cpp
  ${primitive_sources})
add_library(durer::geometry ALIAS durer_geometry)
# 256-bit vectors are only passed to functions that are inlined: how others would pass them is moot.
# Nobody asks what errno says about square roots.
target_compile_options(durer_geometry PRIVATE -Wno-psabi -fno-math-errno)
target_link_libraries(durer_geometry PUBLIC durer_common durer::scene PRIVATE embree fmt::fmt)
