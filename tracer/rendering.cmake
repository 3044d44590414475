# Shading, lights, cameras, transport and film: what makes a picture of the geometry.
find_package(TBB REQUIRED)
durer_entries(camera_sources ${PROJECT_SOURCE_DIR}/scene/cameras.def cameras)
durer_entries(pattern_sources patterns/patterns.def patterns)
durer_entries(warp_sources warps/warps.def warps)

durer_library(tracer
  SOURCES
    chi_square.cpp compile.cpp pigment_queries.cpp unsupported.cpp
    patterns/crackle_cell.cpp patterns/image_sampler.cpp patterns/inner_object.cpp patterns/penrose.cpp
    patterns/tiling_borders.cpp patterns/tilings.cpp patterns/patterns.cpp patterns/program.cpp ${pattern_sources}
    warps/warps.cpp ${warp_sources}
    shading/finish.cpp shading/fog.cpp shading/rainbow.cpp shading/interior.cpp shading/media.cpp shading/normal.cpp shading/pigment.cpp shading/sky.cpp shading/spectrum.cpp
    shading/texture.cpp shading/translucent.cpp
    cameras/camera.cpp ${camera_sources}
    lights/area.cpp lights/light.cpp
    transport/area_shadow.cpp transport/atmosphere.cpp transport/caustics.cpp transport/emitters.cpp transport/irradiance_cache.cpp transport/irradiance_file.cpp transport/light.cpp
    transport/media.cpp transport/media_scattering.cpp transport/media_lights.cpp transport/media_samples.cpp transport/path_lights.cpp transport/path_media.cpp transport/path_surface.cpp
    transport/path_tracer.cpp transport/photon_file.cpp transport/photon_gathering.cpp transport/photon_map.cpp
    transport/photon_plan.cpp transport/plain.cpp transport/plain_lanes.cpp transport/plain_together.cpp transport/photon_search.cpp transport/photon_shooting.cpp transport/photon_tracer.cpp transport/radiosity.cpp transport/shadow.cpp
    transport/subsurface.cpp transport/surface.cpp transport/texture_parts.cpp transport/together.cpp transport/trace.cpp
    film/antialias.cpp film/jitter.cpp film/eye.cpp film/lens.cpp film/lens_points.cpp film/pinhole.cpp film/pretrace.cpp film/progress.cpp
    film/progressive.cpp film/render.cpp
  LINKS durer::geometry durer::scene durer::functions
  PRIVATE_LINKS TBB::tbb fmt::fmt)
# Nobody asks what errno says about square roots.
target_compile_options(durer_tracer PRIVATE -fno-math-errno)
# Wide vectors are only passed to what becomes part of its caller.
set_source_files_properties(film/pinhole.cpp transport/irradiance_cache.cpp transport/photon_search.cpp transport/plain_lanes.cpp
  transport/plain_together.cpp transport/together.cpp
  PROPERTIES COMPILE_OPTIONS -Wno-psabi)
if(TARGET durer::image)
  target_link_libraries(durer_tracer PUBLIC durer::image)
endif()
