# Sources of the core that the program read_meshes has, too: compiled once for both. The program is
# not linked to the core, whose libraries take three times as long to load as all else there.
set(mesh_reading_sources)
foreach(name binary_stl dae_check dae_nodes helper_main mesh_builder mesh_bytes mesh_reader
        message_channel number_text obj_text place ply_check problems stl_check triangulate
        visible_text xml_declaration xml_document)
  list(APPEND mesh_reading_sources ${PROJECT_SOURCE_DIR}/src/model/${name}.cpp)
endforeach()
list(APPEND mesh_reading_sources ${PROJECT_SOURCE_DIR}/src/geometry/weld_vertices.cpp)
add_library(${PROJECT_NAME}_mesh_reading OBJECT ${mesh_reading_sources})
set_target_properties(${PROJECT_NAME}_mesh_reading PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_include_directories(${PROJECT_NAME}_mesh_reading
  PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(${PROJECT_NAME}_mesh_reading
  PRIVATE Eigen3::Eigen assimp::assimp tinyxml2::tinyxml2 strict_warnings)
compile_together(${PROJECT_NAME}_mesh_reading)
