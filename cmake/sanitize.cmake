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
