# The library for other packages: find_package(collision_monitor_core) gives collision_monitor::core.
# The name is its own, because collision_monitorConfig.cmake is catkin's.
include(CMakePackageConfigHelpers)
set(core_package ${PROJECT_NAME}_core)
set(config_destination ${library_destination}/cmake/${core_package})
set(core_config ${core_space}/${config_destination})
configure_package_config_file(cmake/${core_package}Config.cmake.in
  ${core_config}/${core_package}Config.cmake INSTALL_DESTINATION ${config_destination})
write_basic_package_version_file(${core_config}/${core_package}ConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(TARGETS ${core_package} EXPORT ${core_package}
  LIBRARY DESTINATION ${library_destination})
install(EXPORT ${core_package} FILE ${core_package}Targets.cmake NAMESPACE ${PROJECT_NAME}::
  DESTINATION ${config_destination})
export(EXPORT ${core_package} FILE ${core_config}/${core_package}Targets.cmake
  NAMESPACE ${PROJECT_NAME}::)
install(FILES ${core_config}/${core_package}Config.cmake
    ${core_config}/${core_package}ConfigVersion.cmake
  DESTINATION ${config_destination})
install(DIRECTORY include/${PROJECT_NAME}/
  DESTINATION ${include_destination}/${PROJECT_NAME})

if(has_ros)
  install(TARGETS ${PROJECT_NAME}_ros_edge ${PROJECT_NAME}_nodelet
    ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
    LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
    RUNTIME DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION})
  install_program(${PROJECT_NAME}_monitor)
  install(DIRECTORY config launch rviz urdf
    DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
  install(FILES nodelet_plugins.xml
    DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
  catkin_install_python(PROGRAMS tools/play_joint_path.py tools/demo_summary.py
      tools/echo_warnings.py tools/show_in_rviz.py
    DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  # play_joint_path.py imports this from its own folder.
  install(FILES tools/joint_path.py
    DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
endif()
