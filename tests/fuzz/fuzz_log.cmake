# The log reader's fuzz target: gapcheck_fuzz_log_replay replays kept logs and fixed mutations of them,
# gapcheck_fuzz_log (GAPCHECK_FUZZ=ON, clang) is the same function under libFuzzer.
if(NOT TARGET gapcheck_fuzz_log_replay)
  add_executable(gapcheck_fuzz_log_replay ${CMAKE_CURRENT_LIST_DIR}/fuzz_log.cpp ${CMAKE_CURRENT_LIST_DIR}/replay.cpp)
  target_link_libraries(gapcheck_fuzz_log_replay PRIVATE gapcheck_flags gapcheck_results)
  set(corpus ${CMAKE_CURRENT_LIST_DIR}/corpus)
  add_test(NAME fuzz_log_replay
    COMMAND gapcheck_fuzz_log_replay --mutations 2000 ${corpus}/smp.messag ${corpus}/mpp.messag ${corpus}/contacts.d3hsp)
  set_tests_properties(fuzz_log_replay PROPERTIES TIMEOUT 900)
  gapcheck_twin_test(gapcheck_fuzz_log_replay sanitized fuzz_log_replay --mutations 2000 ${corpus}/smp.messag
                     ${corpus}/mpp.messag ${corpus}/contacts.d3hsp)
endif()

if(GAPCHECK_FUZZ AND CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND NOT TARGET gapcheck_fuzz_log)
  add_executable(gapcheck_fuzz_log ${CMAKE_CURRENT_LIST_DIR}/fuzz_log.cpp)
  target_link_libraries(gapcheck_fuzz_log PRIVATE gapcheck_flags gapcheck_results)
  target_link_options(gapcheck_fuzz_log PRIVATE -fsanitize=fuzzer)
endif()
