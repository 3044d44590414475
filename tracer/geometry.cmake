add_library(durer_geometry INTERFACE)
add_library(durer::geometry ALIAS durer_geometry)
target_link_libraries(durer_geometry INTERFACE durer::scene)
