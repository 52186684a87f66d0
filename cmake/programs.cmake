# install_program(TARGET): a program for users. With ROS, rosrun finds it; without, it is in bin/.
function(install_program target)
  set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries_from_program}")
  install(TARGETS ${target} RUNTIME DESTINATION ${program_destination})
endfunction()

# add_program(NAME SOURCE...): adds collision_monitor_NAME. Its file is called NAME with ROS, where
# the package's name goes before it (rosrun), and collision_monitor_NAME without.
function(add_program name)
  add_executable(${PROJECT_NAME}_${name} ${ARGN})
  if(has_ros)
    set_target_properties(${PROJECT_NAME}_${name} PROPERTIES OUTPUT_NAME ${name} PREFIX "")
  endif()
  install_program(${PROJECT_NAME}_${name})
endfunction()

# add_helper(NAME SOURCE...): a program that the library starts, not the user. It does work that may
# crash or hang. src/model/mesh_loading/find_helper.cpp looks for it where this puts it.
function(add_helper name)
  add_executable(${PROJECT_NAME}_${name} ${ARGN})
  set_target_properties(${PROJECT_NAME}_${name} PROPERTIES OUTPUT_NAME ${name} PREFIX "")
  if(NOT has_ros)
    set_target_properties(${PROJECT_NAME}_${name} PROPERTIES
      RUNTIME_OUTPUT_DIRECTORY ${core_space}/${helper_destination})
  endif()
  install(TARGETS ${PROJECT_NAME}_${name} RUNTIME DESTINATION ${helper_destination})
endfunction()
