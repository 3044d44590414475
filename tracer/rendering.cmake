# Shading, lights, cameras, transport and film: what makes a picture of the geometry.
find_package(TBB REQUIRED)
durer_entries(pattern_sources patterns/patterns.def patterns)

durer_library(tracer
  SOURCES
    compile.cpp pigment_queries.cpp unsupported.cpp
    patterns/patterns.cpp ${pattern_sources}
    shading/finish.cpp shading/interior.cpp shading/pigment.cpp shading/sky.cpp shading/spectrum.cpp
    shading/texture.cpp
    lights/light.cpp
    transport/light.cpp transport/surface.cpp transport/trace.cpp
    film/antialias.cpp film/jitter.cpp film/progress.cpp film/render.cpp
  LINKS durer::functions durer::geometry durer::scene
  PRIVATE_LINKS TBB::tbb fmt::fmt)
if(TARGET durer::image)
  target_link_libraries(durer_tracer PUBLIC durer::image)
endif()
