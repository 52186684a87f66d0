# The target `doc`: pages of the library by Doxygen, in doc/html of the build. Only where this package
# is built alone: a project around it may have a target of this name.
if(NOT CMAKE_SOURCE_DIR STREQUAL PROJECT_SOURCE_DIR)
  return()
endif()
find_package(Doxygen QUIET)
if(NOT TARGET Doxygen::doxygen)  # catkin sets DOXYGEN_FOUND by itself
  leave_out("target doc, and its test" Doxygen)
  return()
endif()
configure_file(docs/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
set(make_pages Doxygen::doxygen ${PROJECT_BINARY_DIR}/Doxyfile)
add_custom_target(doc COMMAND ${make_pages} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
if(CATKIN_ENABLE_TESTING)
  add_test(NAME doc COMMAND ${make_pages} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
endif()
