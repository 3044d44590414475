# What every target of the house shares: the language level, warnings and sanitizers as interface
# targets, and durer_library() to make one target per folder.

add_library(durer_warnings INTERFACE)
add_library(durer::warnings ALIAS durer_warnings)
target_compile_options(durer_warnings INTERFACE
  # GCC 12 warns of overlaps in std::string that are not there (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror=switch
  $<$<BOOL:${DURER_WARNINGS_AS_ERRORS}>:-Werror>)

add_library(durer_sanitizers INTERFACE)
add_library(durer::sanitizers ALIAS durer_sanitizers)
if(DURER_SANITIZE)
  # With sanitizers GCC 12 also sees uninitialised members in std::regex.
  target_compile_options(durer_warnings INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_compile_options(durer_sanitizers INTERFACE -fsanitize=${DURER_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(durer_sanitizers INTERFACE -fsanitize=${DURER_SANITIZE})
endif()

# Rules that hold for every translation unit: C++20, one include root, and no contraction of
# multiply-add, so that golden pictures agree between compilers.
add_library(durer_common INTERFACE)
target_compile_features(durer_common INTERFACE cxx_std_20)
target_compile_options(durer_common INTERFACE -ffp-contract=off)
target_include_directories(durer_common INTERFACE ${PROJECT_SOURCE_DIR})
target_link_libraries(durer_common INTERFACE durer::warnings durer::sanitizers)

# durer_library(name SOURCES a.cpp … LINKS durer::base … PRIVATE_LINKS …): a static library
# durer_<name> with the alias durer::<name>.
function(durer_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(durer_${name} STATIC ${ARG_SOURCES})
  add_library(durer::${name} ALIAS durer_${name})
  target_link_libraries(durer_${name} PUBLIC durer_common ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
endfunction()

# durer_entries(out file.def folder): the sources that a registration list names: each line
# DURER_ENTRY(x) stands for <folder>/x.cpp. Editing the list re-runs CMake.
function(durer_entries out list folder)
  file(STRINGS ${list} lines REGEX "^DURER_ENTRY")
  set(sources "")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^DURER_ENTRY\\(([a-z0-9_]+).*" "\\1" entry "${line}")
    list(APPEND sources ${folder}/${entry}.cpp)
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  set(${out} ${sources} PARENT_SCOPE)
endfunction()
