# Whether there is ROS (`has_ros`). Finds its packages and makes the messages.
#catkin_lint: ignore missing_required

# rosrun does not look below a package's own build folder. So a build in there keeps its devel space
# beside it, as catkin_make does.
if(NOT CATKIN_DEVEL_PREFIX AND CMAKE_BINARY_DIR STREQUAL "${PROJECT_SOURCE_DIR}/build")
  set(CATKIN_DEVEL_PREFIX "${PROJECT_SOURCE_DIR}/devel")
endif()

if(COLLISION_MONITOR_ROS STREQUAL "AUTO")
  # Within another project, ROS is used only if that is a catkin workspace.
  set(catkin_FOUND OFF)
  if(CMAKE_SOURCE_DIR STREQUAL PROJECT_SOURCE_DIR OR CATKIN_TOPLEVEL)
    find_package(catkin QUIET)
  endif()
  set(has_ros ${catkin_FOUND})
  if(NOT has_ros)
    leave_out("node, nodelet and messages" catkin)
  endif()
elseif(COLLISION_MONITOR_ROS MATCHES "^(ON|OFF)$")
  set(has_ros ${COLLISION_MONITOR_ROS})
else()
  message(FATAL_ERROR "COLLISION_MONITOR_ROS is '${COLLISION_MONITOR_ROS}'; accepted: ON, OFF, AUTO")
endif()
if(NOT has_ros)
  message(STATUS "Building the core without ROS")
  set(CATKIN_ENABLE_TESTING ${COLLISION_MONITOR_TESTS})
  return()
endif()

set(ros_packages
  diagnostic_msgs
  diagnostic_updater
  geometry_msgs
  nodelet
  pluginlib
  resource_retriever
  roscpp
  rospack
  sensor_msgs
  shape_msgs
  std_msgs
  std_srvs
  tf2
  tf2_msgs
  tf2_ros
  trajectory_msgs
  visualization_msgs
)
find_package(catkin REQUIRED COMPONENTS message_generation ${ros_packages})

add_message_files(FILES
  Contact.msg
  Contacts.msg
  Distances.msg
  LinkApproach.msg
  LinkDistance.msg
  RobotState.msg
  State.msg
  PairWarning.msg
  SceneChange.msg
  SceneObject.msg
  SceneObjects.msg
)
add_service_files(FILES
  ApplyObjects.srv
  CheckStates.srv
  CheckTrajectory.srv
  ExplainPair.srv
  GetDistances.srv
  GetObjects.srv
  SetLimits.srv
  SetPairs.srv
)
generate_messages(DEPENDENCIES geometry_msgs sensor_msgs shape_msgs std_msgs trajectory_msgs)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES ${PROJECT_NAME}_core ${PROJECT_NAME}_ros_edge
  CATKIN_DEPENDS message_runtime ${ros_packages}
  DEPENDS EIGEN3
)

# catkin gives its definitions and include folders to everything in this folder. The core gets none
# of them, so that it is the same library with and without ROS.
get_directory_property(ros_definitions COMPILE_DEFINITIONS)
get_directory_property(message_includes INCLUDE_DIRECTORIES)
set_directory_properties(PROPERTIES COMPILE_DEFINITIONS "" INCLUDE_DIRECTORIES "")

# use_ros(TARGET): compiles against ROS and the messages of this package.
function(use_ros target)
  add_dependencies(${target} ${${PROJECT_NAME}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS})
  target_compile_definitions(${target} PRIVATE ${ros_definitions})
  target_include_directories(${target} PRIVATE ${message_includes})
  target_include_directories(${target} SYSTEM PRIVATE ${catkin_INCLUDE_DIRS})
endfunction()
