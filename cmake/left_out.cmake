# What is not built, because a package is missing or nobody asks for it, is told at the end.

# leave_out(WHAT PACKAGE...): notes what is not built for want of these.
function(leave_out what)
  list(JOIN ARGN ", " packages)
  set_property(GLOBAL APPEND PROPERTY ${PROJECT_NAME}_LEFT_OUT "${what} (${packages})")
endfunction()

function(tell_what_is_left_out)
  get_property(lines GLOBAL PROPERTY ${PROJECT_NAME}_LEFT_OUT)
  if(lines)
    message(STATUS "Left out, for want of what is in brackets; docs/install.md names the packages:")
  endif()
  foreach(line IN LISTS lines)
    message(STATUS "  ${line}")
  endforeach()
endfunction()
