# Compiler options that every target of this package shares.
# `strict_warnings` is linked PRIVATE, so that users of the package are not bound to it.
add_library(strict_warnings INTERFACE)
target_compile_options(strict_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(COLLISION_MONITOR_WERROR)
  target_compile_options(strict_warnings INTERFACE -Werror)
endif()

if(COLLISION_MONITOR_SANITIZE)
  # A null pointer stops the program without help; these checks only make the build slow.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined
                      -fno-sanitize=object-size,vptr,null,nonnull-attribute,returns-nonnull-attribute
                      -fno-omit-frame-pointer -g1 -O1)
  add_link_options(-fsanitize=address,undefined)
endif()

# Same bytes on every machine: no fused multiply-add where the source does not say so.
add_compile_options(-ffp-contract=off)

# Most of the compile time is reading the same headers. Sources still include what
# they use: clang-tidy reads them without this. CMAKE_DISABLE_PRECOMPILE_HEADERS=ON turns it off.
set(core_headers <algorithm> <array> <cmath> <functional> <map> <memory> <optional> <string>
  <variant> <vector> <Eigen/Core> <Eigen/Geometry>)
set(test_headers ${core_headers} <gtest/gtest.h> <rapidcheck.h>)
set(edge_headers ${core_headers} <ros/ros.h>)
