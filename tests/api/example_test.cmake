# Runs PROGRAM with ARGUMENTS: its exit code and the whole of its standard output match EXIT_CODE and PATTERN.
execute_process(COMMAND ${PROGRAM} ${ARGUMENTS} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE errors)
if(NOT status MATCHES "^${EXIT_CODE}$")
  message(FATAL_ERROR "exit code ${status} instead of ${EXIT_CODE}\n${output}\n${errors}")
endif()
# An empty pattern stands for no output.
if(NOT output MATCHES "^${PATTERN}$" AND NOT "${output}${PATTERN}" STREQUAL "")
  message(FATAL_ERROR "prints:\n${output}\n${errors}\ninstead of:\n${PATTERN}")
endif()
