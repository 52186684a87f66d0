# The edge: ROS in and out. Node and nodelet both run the same Monitor.
file(GLOB_RECURSE edge_sources CONFIGURE_DEPENDS src/ros_edge/*.cpp)
list(FILTER edge_sources EXCLUDE REGEX "_(node|nodelet)\\.cpp$")
add_library(${PROJECT_NAME}_ros_edge ${edge_sources})
use_ros(${PROJECT_NAME}_ros_edge)
target_include_directories(${PROJECT_NAME}_ros_edge PRIVATE src)
target_link_libraries(${PROJECT_NAME}_ros_edge
  PUBLIC ${PROJECT_NAME}_core ${catkin_LIBRARIES} PRIVATE strict_warnings)
target_precompile_headers(${PROJECT_NAME}_ros_edge PRIVATE ${edge_headers})
compile_together(${PROJECT_NAME}_ros_edge)

add_executable(${PROJECT_NAME}_monitor src/ros_edge/node/monitor_node.cpp)
set_target_properties(${PROJECT_NAME}_monitor PROPERTIES OUTPUT_NAME monitor PREFIX "")
use_ros(${PROJECT_NAME}_monitor)
target_include_directories(${PROJECT_NAME}_monitor PRIVATE src)
target_link_libraries(${PROJECT_NAME}_monitor PRIVATE ${PROJECT_NAME}_ros_edge strict_warnings)

add_library(${PROJECT_NAME}_nodelet src/ros_edge/node/monitor_nodelet.cpp)
use_ros(${PROJECT_NAME}_nodelet)
target_include_directories(${PROJECT_NAME}_nodelet PRIVATE src)
target_link_libraries(${PROJECT_NAME}_nodelet PRIVATE ${PROJECT_NAME}_ros_edge strict_warnings)
set_target_properties(${PROJECT_NAME}_ros_edge ${PROJECT_NAME}_nodelet PROPERTIES
  INSTALL_RPATH "$ORIGIN")
