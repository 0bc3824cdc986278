# Flags as INTERFACE targets: gapcheck_flags for all of our own code.
add_library(gapcheck_flags INTERFACE)
target_include_directories(gapcheck_flags INTERFACE ${PROJECT_SOURCE_DIR}/lib)
target_compile_options(gapcheck_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wcast-align)
# g++ 12 warns of overlapping copies inside its own std::string (GCC bug 105329).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(gapcheck_flags INTERFACE -Wno-restrict)
endif()
if(GAPCHECK_WERROR)
  target_compile_options(gapcheck_flags INTERFACE -Werror)
endif()
# Error bounds are proven for IEEE doubles without contraction.
target_compile_options(gapcheck_flags INTERFACE -ffp-contract=off)
if("${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE}" MATCHES "-ffast-math|-Ofast|-funsafe-math")
  message(FATAL_ERROR "gapcheck decides exactly; -ffast-math and its relatives break the proofs. Remove them from CMAKE_CXX_FLAGS.")
endif()
if(GAPCHECK_SANITIZE)
  # Instrumented std::variant and std::regex look uninitialised to g++ 12.
  target_compile_options(gapcheck_flags INTERFACE -Wno-maybe-uninitialized)
  target_compile_options(gapcheck_flags INTERFACE -fsanitize=${GAPCHECK_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(gapcheck_flags INTERFACE -fsanitize=${GAPCHECK_SANITIZE})
endif()

find_program(GAPCHECK_CCACHE ccache)
if(GAPCHECK_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${GAPCHECK_CCACHE})
endif()
