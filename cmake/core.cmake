# The core: all geometry, no ROS. tools/check_layers.py checks which rooms may include each other.
find_package(assimp REQUIRED)
find_package(Qhull REQUIRED)
find_package(tinyxml2 REQUIRED)
find_library(urdfdom_model_library urdfdom_model REQUIRED)
find_library(console_bridge_library console_bridge REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(hwy REQUIRED)
include(cmake/mesh_reading.cmake)

set(core_sources)
foreach(room geometry fitting model broad_phase narrow_phase motion pipeline library)
  file(GLOB_RECURSE room_sources CONFIGURE_DEPENDS src/${room}/*.cpp)
  list(APPEND core_sources ${room_sources})
endforeach()
list(REMOVE_ITEM core_sources ${mesh_reading_sources})
# Shared, because it looks for its helper programs beside itself.
add_library(${PROJECT_NAME}_core SHARED
  ${core_sources} $<TARGET_OBJECTS:${PROJECT_NAME}_mesh_reading>)
target_include_directories(${PROJECT_NAME}_core
  PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${include_destination}>
  PRIVATE src)
target_compile_features(${PROJECT_NAME}_core PUBLIC cxx_std_17)
target_link_libraries(${PROJECT_NAME}_core
  PUBLIC Eigen3::Eigen
  PRIVATE ${CMAKE_DL_LIBS} assimp::assimp Qhull::qhull_r tinyxml2::tinyxml2 yaml-cpp OpenSSL::Crypto hwy::hwy
    ${urdfdom_model_library} ${console_bridge_library}
    $<BUILD_INTERFACE:strict_warnings>)
target_precompile_headers(${PROJECT_NAME}_core PRIVATE ${core_headers})
compile_folders_together(${PROJECT_NAME}_core ${core_sources})
# Searches make many small calls. Calls within the library then need no look-up when it is loaded.
target_link_options(${PROJECT_NAME}_core PRIVATE -Wl,-Bsymbolic-functions)
# Other packages link collision_monitor::core: from a build, an installation or a subfolder.
add_library(${PROJECT_NAME}::core ALIAS ${PROJECT_NAME}_core)
set_target_properties(${PROJECT_NAME}_core PROPERTIES EXPORT_NAME core)
