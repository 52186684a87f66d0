# How tests are made known to ctest. With ROS, catkin's run_tests and catkin_test_results know them,
# too: each test in C++ writes its results as XML where catkin looks for them, and run_tests runs
# ctest, which adds one file with the results of all.
if(has_ros)
  set(results_dir ${CATKIN_TEST_RESULTS_DIR}/${PROJECT_NAME})
else()
  set(results_dir ${PROJECT_BINARY_DIR}/test_results)
  if(NOT PYTHON_EXECUTABLE)
    find_program(PYTHON_EXECUTABLE python3 REQUIRED)
  endif()
endif()

# add_cpp_test(NAME PROGRAM): a GoogleTest program.
function(add_cpp_test name program)
  add_test(NAME ${name} COMMAND ${program})
  set_tests_properties(${name} PROPERTIES
    ENVIRONMENT "GTEST_OUTPUT=xml:${results_dir}/gtest-${name}.xml")
endfunction()

# Tests in Python of the sources, the programs, the configuration and the installation.
function(add_python_tests)
  foreach(check layers names unreached_functions)
    add_test(NAME ${check}
      COMMAND ${PYTHON_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/layers/${check}_test.py)
  endforeach()
  set_tests_properties(unreached_functions PROPERTIES ENVIRONMENT "CXX=${CMAKE_CXX_COMPILER}")
  add_test(NAME tools COMMAND ${PYTHON_EXECUTABLE} -m unittest discover
    -s ${CMAKE_CURRENT_SOURCE_DIR}/tools -p "*_test.py")
  set(programs FIT fit PAIRS pairs EXPLAIN explain MONITOR monitor TWO_CAPSULES two_capsules COMPARE compare_with_fcl)
  if(NOT PNG_FOUND)
    list(REMOVE_ITEM programs FIT fit)
  endif()
  set(program_files)
  while(programs)
    list(POP_FRONT programs variable program)
    if(TARGET ${PROJECT_NAME}_${program})
      list(APPEND program_files COLLISION_MONITOR_${variable}=$<TARGET_FILE:${PROJECT_NAME}_${program}>)
    endif()
  endwhile()
  set_tests_properties(tools PROPERTIES ENVIRONMENT "${program_files}")
  add_test(NAME configure
    COMMAND ${PYTHON_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/configure/configure_test.py)
  set_tests_properties(configure PROPERTIES
    ENVIRONMENT "COLLISION_MONITOR_CMAKE=${CMAKE_COMMAND};COLLISION_MONITOR_HAS_ROS=$<BOOL:${has_ros}>")
  add_test(NAME install
    COMMAND ${PYTHON_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/install/install_test.py)
  set(install_environment COLLISION_MONITOR_BUILD=${PROJECT_BINARY_DIR} COLLISION_MONITOR_SPACE=${core_space}
    COLLISION_MONITOR_CMAKE=${CMAKE_COMMAND} COLLISION_MONITOR_HAS_ROS=$<BOOL:${has_ros}>)
  set_tests_properties(install PROPERTIES ENVIRONMENT "${install_environment}")
endfunction()

# add_run_tests(): with ROS, builds everything and runs ctest. As catkin has it, run_tests itself does
# not fail; catkin_test_results tells what did. ctest's file lacks an attribute that it asks for.
function(add_run_tests)
  set(results ${results_dir}/ctest.xml)
  set(tests_to_results "'${CMAKE_CTEST_COMMAND}' --output-on-failure")
  if(NOT CMAKE_VERSION VERSION_LESS 3.21)
    string(APPEND tests_to_results
      " --output-junit '${results}'; sed -i 's/<testsuite /&errors=\"0\" /' '${results}'")
  endif()
  add_custom_target(run_tests_${PROJECT_NAME}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${results_dir}
    COMMAND sh -c "${tests_to_results}; true"
    WORKING_DIRECTORY ${PROJECT_BINARY_DIR} USES_TERMINAL VERBATIM)
  add_dependencies(run_tests run_tests_${PROJECT_NAME})
  add_targets_to_run_tests(${PROJECT_SOURCE_DIR})
endfunction()

# Lets run_tests build the programs and libraries of a folder and those below.
function(add_targets_to_run_tests folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type MATCHES "EXECUTABLE|_LIBRARY")
      add_dependencies(run_tests_${PROJECT_NAME} ${target})
    endif()
  endforeach()
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  list(FILTER folders INCLUDE REGEX "^${PROJECT_SOURCE_DIR}/")
  foreach(below IN LISTS folders)
    add_targets_to_run_tests(${below})
  endforeach()
endfunction()
