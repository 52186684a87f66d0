# Sources of the core that the program read_meshes uses too, compiled once for both. The program
# does not link the core, whose libraries take three times as long to load as all the rest.
set(mesh_reading_sources)
foreach(name mesh_loading/helper_main mesh_loading/message_channel mesh_files/binary_stl
        mesh_files/dae_check mesh_files/dae_nodes mesh_files/mesh_builder mesh_files/mesh_bytes
        mesh_files/mesh_reader mesh_files/obj_text mesh_files/ply_check mesh_files/stl_check
        mesh_files/triangulate number_text place problems xml_declaration xml_document visible_text)
  list(APPEND mesh_reading_sources ${PROJECT_SOURCE_DIR}/src/model/${name}.cpp)
endforeach()
foreach(name flat_triangles weld_vertices)
  list(APPEND mesh_reading_sources ${PROJECT_SOURCE_DIR}/src/geometry/meshes/${name}.cpp)
endforeach()
add_library(${PROJECT_NAME}_mesh_reading OBJECT ${mesh_reading_sources})
set_target_properties(${PROJECT_NAME}_mesh_reading PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_include_directories(${PROJECT_NAME}_mesh_reading
  PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(${PROJECT_NAME}_mesh_reading
  PRIVATE Eigen3::Eigen assimp::assimp tinyxml2::tinyxml2 strict_warnings)
compile_together(${PROJECT_NAME}_mesh_reading)
