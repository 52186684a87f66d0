# Compiler options that every target of this package shares.
# `strict_warnings` is linked PRIVATE, so that users of the package are not bound to it.
add_library(strict_warnings INTERFACE)
target_compile_options(strict_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(COLLISION_MONITOR_WERROR)
  target_compile_options(strict_warnings INTERFACE -Werror)
endif()

# Same bytes on every machine: no fused multiply-add where the source does not say so.
add_compile_options(-ffp-contract=off)

# Each function in a section of its own: tools/unreached_functions.py follows who calls whom.
add_compile_options(-ffunction-sections -fdata-sections)

# Most of the compile time is reading the same headers. Sources still include what
# they use: clang-tidy reads them without this. CMAKE_DISABLE_PRECOMPILE_HEADERS=ON turns it off.
set(core_headers <algorithm> <array> <cmath> <functional> <map> <memory> <optional> <string>
  <variant> <vector> <Eigen/Core> <Eigen/Geometry>)
set(test_headers ${core_headers} <gtest/gtest.h> <rapidcheck.h>)
set(edge_headers ${core_headers} <ros/ros.h>)

# Most of the rest is instantiating the same templates: neighbours compiled together take a third of
# the time. The core is not, but for what reads meshes, so that each of its files is optimized by itself; under the sanitizers
# it is. That each source includes what it uses, a build with COLLISION_MONITOR_UNITY=OFF shows, as
# does clang-tidy in .ci/run, which reads them alone.
function(compile_together)
  set_target_properties(${ARGN} PROPERTIES
    UNITY_BUILD ${COLLISION_MONITOR_UNITY} UNITY_BUILD_BATCH_SIZE 16)
endfunction()
