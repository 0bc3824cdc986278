# gapcheck_refuse_fast_math(): ends the configuration if a compiler flag anywhere lets arithmetic be rearranged or taken as
# free of NaN and infinities. The error bounds of the decisions are proven for IEEE doubles (docs/theory/decisions.md).
# -ffp-contract is allowed: the proofs hold with fused operations too. Checked: CMAKE_CXX_FLAGS and those of all
# configurations, options of the directory, words after the compiler's name, and CXXFLAGS of the environment.
function(gapcheck_refuse_fast_math)
  set(flags
    -Ofast
    -ffast-math
    -funsafe-math-optimizations
    -fassociative-math
    -freciprocal-math
    -ffinite-math-only
    -fno-signed-zeros
    -fno-honor-nans
    -fno-honor-infinities
    -fapprox-func
    -ffp-model=fast
    -ffp-model=aggressive
    -fsingle-precision-constant
    -mfpmath=387
    -mrecip)
  string(REPLACE ";" "|" pattern "${flags}")
  get_cmake_property(names VARIABLES)
  list(FILTER names INCLUDE REGEX "^CMAKE_CXX_(FLAGS($|_)|COMPILER_ARG1$)")
  foreach(name ${names})
    gapcheck_refuse_flags_in("${name}" "${${name}}" "${pattern}")
  endforeach()
  gapcheck_refuse_flags_in("CXXFLAGS of the environment" "$ENV{CXXFLAGS}" "${pattern}")
  if(NOT CMAKE_SCRIPT_MODE_FILE)
    get_directory_property(options COMPILE_OPTIONS)
    gapcheck_refuse_flags_in("COMPILE_OPTIONS of the directory" "${options}" "${pattern}")
  endif()
endfunction()

# A flag may have a value: -mrecip=all.
function(gapcheck_refuse_flags_in place text pattern)
  if(" ${text} " MATCHES "[ ;\"'](${pattern})[ ;\"'=]")
    message(FATAL_ERROR "gapcheck decides exactly, and ${CMAKE_MATCH_1} breaks the proofs of its error bounds. "
                        "Remove it from ${place}.")
  endif()
endfunction()
