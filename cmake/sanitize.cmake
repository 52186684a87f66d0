# How COLLISION_MONITOR_SANITIZE builds: its value names the sanitizers, as in `address,undefined`.
if(COLLISION_MONITOR_SANITIZE)
  # A null pointer stops the program without help; these checks only make the build slow.
  add_compile_options(-fsanitize=${COLLISION_MONITOR_SANITIZE} -fno-sanitize-recover=undefined
                      -fno-sanitize=object-size,vptr,null,nonnull-attribute,returns-nonnull-attribute
                      -fno-omit-frame-pointer -g1 -O1)
  add_link_options(-fsanitize=${COLLISION_MONITOR_SANITIZE})
  if(COLLISION_MONITOR_SANITIZE MATCHES thread)
    # Else libraries of ROS, which are not watched, lend theirs of std::shared_ptr, and no thread is
    # seen to give its share back before the last one ends what was shared.
    add_link_options(-Wl,-Bsymbolic-functions)
  endif()
endif()

# sanitize_quickly(LIBRARY SOURCE...): rooms whose files name nothing alike are compiled in one go.
# In kernels for lanes every operation is a call whose values have a scope of their own: to watch
# those scopes takes three times as long as all other checks together, which stay.
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
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${CMAKE_MATCH_1})
    endif()
  endforeach()
endfunction()
