# A rostest starts its own master and nodes, waits for conditions with a deadline, and never sleeps
# blindly.
file(GLOB rostests CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/launch/*.test)
foreach(file ${rostests})
  get_filename_component(name ${file} NAME_WE)
  add_test(NAME ros_edge_${name}
    COMMAND ${CMAKE_COMMAND} -E env PATH=/usr/bin:$ENV{PATH}
      ${CATKIN_DEVEL_PREFIX}/env.sh rostest --pkgdir=${PROJECT_SOURCE_DIR} --package=${PROJECT_NAME}
      --results-base-dir=${CATKIN_TEST_RESULTS_DIR} ${file})
  # rostest ends with 0 whatever the result, and says SUCCESS where no test ran at all.
  set_tests_properties(ros_edge_${name} PROPERTIES
    TIMEOUT 180 PASS_REGULAR_EXPRESSION "RESULT: SUCCESS[^A-Z]*TESTS: [1-9]")
endforeach()
