# Helpers and programs that need ROS.
set(loading ${PROJECT_SOURCE_DIR}/src/model/mesh_loading)
add_helper(fetch_resource helpers/fetch_resource.cpp
  ${loading}/helper_main.cpp ${loading}/message_channel.cpp)
use_ros(${PROJECT_NAME}_fetch_resource)
target_link_libraries(${PROJECT_NAME}_fetch_resource PRIVATE ${catkin_LIBRARIES} strict_warnings)

add_library(${PROJECT_NAME}_two_capsules_parts STATIC two_capsules/exercise.cpp)
target_include_directories(${PROJECT_NAME}_two_capsules_parts
  PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/two_capsules)
target_link_libraries(${PROJECT_NAME}_two_capsules_parts
  PUBLIC ${PROJECT_NAME}_core PRIVATE strict_warnings)

add_program(two_capsules
  two_capsules/two_capsules.cpp two_capsules/draw.cpp two_capsules/keyboard.cpp)
use_ros(${PROJECT_NAME}_two_capsules)
target_link_libraries(${PROJECT_NAME}_two_capsules
  PRIVATE ${PROJECT_NAME}_two_capsules_parts ${PROJECT_NAME}_ros_edge strict_warnings)
compile_together(${PROJECT_NAME}_two_capsules)
