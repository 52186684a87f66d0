# Compiler options that all targets of this package share. `strict_warnings` is linked PRIVATE, so
# that it does not bind users of the package.
add_library(strict_warnings INTERFACE)
target_compile_options(strict_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(COLLISION_MONITOR_WERROR)
  target_compile_options(strict_warnings INTERFACE -Werror)
endif()

# Same bytes on every machine: no fused multiply-add unless the source asks for it.
add_compile_options(-ffp-contract=off)

# Each function has its own section: tools/unreached_functions.py follows the calls between them.
add_compile_options(-ffunction-sections -fdata-sections)

# Most compile time goes into reading the same headers. Sources still include what they use:
# clang-tidy reads them without this. CMAKE_DISABLE_PRECOMPILE_HEADERS=ON turns it off.
set(core_headers <algorithm> <array> <cmath> <functional> <map> <memory> <optional> <string>
  <variant> <vector> <Eigen/Core> <Eigen/Geometry>)
set(test_headers ${core_headers} <gtest/gtest.h> <rapidcheck.h>)
set(edge_headers ${core_headers} <ros/ros.h>)

# Most of the rest goes into instantiating the same templates: sources compiled together take a
# third of the time. COLLISION_MONITOR_UNITY=OFF and clang-tidy in .ci/run compile every source
# alone, and so show whether it includes what it uses.
function(compile_together)
  set_target_properties(${ARGN} PROPERTIES
    UNITY_BUILD ${COLLISION_MONITOR_UNITY} UNITY_BUILD_BATCH_SIZE 16)
endfunction()

# compile_folders_together(LIBRARY SOURCE...): the sources of a folder of src/ are compiled together,
# so no two of them may share a name. Kernels for lanes include themselves once for each instruction
# set and stay alone. In them every operation is a call whose values have their own scope. Checking
# these scopes takes three times as long as all other checks, which stay on.
function(compile_folders_together library)
  set_target_properties(${library} PROPERTIES
    UNITY_BUILD ${COLLISION_MONITOR_UNITY} UNITY_BUILD_MODE GROUP)
  foreach(source ${ARGN})
    get_filename_component(folder ${source} DIRECTORY)
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/src ${folder})
    file(STRINGS ${source} lanes REGEX "hwy/foreach_target\\.h" LIMIT_COUNT 1)
    if(lanes AND COLLISION_MONITOR_SANITIZE)
      set_source_files_properties(${source} PROPERTIES
        COMPILE_OPTIONS -fno-sanitize-address-use-after-scope)
    elseif(NOT lanes)
      string(REPLACE / _ group ${folder})
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
    endif()
  endforeach()
endfunction()
