# How to build with COLLISION_MONITOR_SANITIZE. Its value names the sanitizers: `address,undefined`.
if(COLLISION_MONITOR_SANITIZE)
  # A null pointer stops the program anyway, and the address sanitizer sees where a pointer leads:
  # these checks only slow the build.
  add_compile_options(-fsanitize=${COLLISION_MONITOR_SANITIZE} -fno-sanitize-recover=undefined
                      -fno-sanitize=object-size,vptr,null,nonnull-attribute,returns-nonnull-attribute
                      -fno-sanitize=alignment,pointer-overflow
                      -fno-omit-frame-pointer -g1 -O1)
  add_link_options(-fsanitize=${COLLISION_MONITOR_SANITIZE})
  # Otherwise programs and the ROS libraries, which are not instrumented, provide what headers define
  # (std::shared_ptr, for one), and the sanitizer misses what it does.
  add_link_options(-Wl,-Bsymbolic-functions)
endif()
