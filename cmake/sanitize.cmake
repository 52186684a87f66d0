# How to build with COLLISION_MONITOR_SANITIZE. Its value names the sanitizers: `address,undefined`.
if(COLLISION_MONITOR_SANITIZE)
  # A null pointer stops the program anyway; these checks only slow the build.
  add_compile_options(-fsanitize=${COLLISION_MONITOR_SANITIZE} -fno-sanitize-recover=undefined
                      -fno-sanitize=object-size,vptr,null,nonnull-attribute,returns-nonnull-attribute
                      -fno-omit-frame-pointer -g1 -O1)
  add_link_options(-fsanitize=${COLLISION_MONITOR_SANITIZE})
  if(COLLISION_MONITOR_SANITIZE MATCHES thread)
    # Otherwise the ROS libraries, which are not instrumented, provide std::shared_ptr. The
    # sanitizer then misses that a thread gives up its share before the last one destroys the
    # object.
    add_link_options(-Wl,-Bsymbolic-functions)
  endif()
endif()

# sanitize_quickly(LIBRARY SOURCE...): compiles rooms together whose files share no names, so not
# the readers of objects. In kernels for lanes every operation is a call whose values have their own
# scope. Checking these scopes takes three times as long as all other checks, which stay on.
function(sanitize_quickly library)
  if(NOT COLLISION_MONITOR_SANITIZE)
    return()
  endif()
  set_target_properties(${library} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(source ${ARGN})
    file(STRINGS ${source} lanes REGEX "hwy/foreach_target\\.h" LIMIT_COUNT 1)
    string(REGEX MATCH "/src/(broad_phase|model|motion|pipeline)/" room ${source})
    if(lanes)
      set_source_files_properties(${source} PROPERTIES
        COMPILE_OPTIONS -fno-sanitize-address-use-after-scope)
    elseif(room)
      set(group ${CMAKE_MATCH_1})
      if(NOT source MATCHES "/src/model/world/")
        set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
      endif()
    endif()
  endforeach()
endfunction()
