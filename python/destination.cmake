# Where the package is built (`python_space`) and installed (`python_destination`, below the prefix;
# `library_from_module` leads from there to the library).
if(CATKIN_GLOBAL_PYTHON_DESTINATION)
  set(python_destination ${CATKIN_GLOBAL_PYTHON_DESTINATION})
  set(python_space ${CATKIN_DEVEL_PREFIX}/${CATKIN_GLOBAL_PYTHON_DESTINATION})
  set(library_from_prefix ${CATKIN_PACKAGE_LIB_DESTINATION})
else()
  # The folder below the prefix where the interpreter looks by itself, if there is one: for /usr,
  # /usr/local, and ~/.local of the one who installs.
  execute_process(COMMAND ${Python3_EXECUTABLE} -c
    "import os, site
prefix = os.path.realpath('${CMAKE_INSTALL_PREFIX}') + os.sep
folders = site.getsitepackages() + [os.path.realpath(site.getusersitepackages())]
print(next((f[len(prefix):] for f in folders if f.startswith(prefix + 'lib')), ''), end='')"
    OUTPUT_VARIABLE python_destination)
  if(NOT python_destination)
    set(python_destination lib/python3/dist-packages)
  endif()
  set(python_space ${PROJECT_BINARY_DIR}/lib/python3/dist-packages)
  include(GNUInstallDirs)
  set(library_from_prefix ${CMAKE_INSTALL_LIBDIR})
endif()
file(RELATIVE_PATH library_from_module
  /${python_destination}/${PROJECT_NAME}_core /${library_from_prefix})
