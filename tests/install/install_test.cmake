# Any step that fails ends the test.
function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${status}\n${output}\n${errors}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(prefix ${WORK}/prefix)
file(REMOVE_RECURSE ${prefix} ${WORK}/consumer)
step(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
foreach(file bin/gapcheck bin/check-c share/man/man1/gapcheck.1 share/man/man1/check-c.1
        share/bash-completion/completions/gapcheck share/zsh/vendor-completions/_check-c)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()

step(${prefix}/bin/gapcheck --version)
if(NOT output MATCHES "^gapcheck [0-9.]+ \\(commit [0-9a-f]+\\+?, .+, CGAL [0-9.]+, [A-Za-z]*\\)" AND
   NOT output MATCHES "commit unknown")
  message(FATAL_ERROR "gapcheck --version prints: ${output}")
endif()
step(bash -c "source '${prefix}/share/bash-completion/completions/gapcheck'
  COMP_WORDS=(gapcheck audit --format sa) COMP_CWORD=3; _gapcheck; [ \"\${COMPREPLY[*]}\" = sarif ] || exit 1
  COMP_WORDS=(gapcheck au) COMP_CWORD=1; _gapcheck; [ \"\${COMPREPLY[*]}\" = audit ] || exit 2
  COMP_WORDS=(gapcheck compare --cu) COMP_CWORD=2; _gapcheck; [[ \" \${COMPREPLY[*]} \" = *' --curves '* ]] || exit 3
  COMP_WORDS=(gapcheck audit --conf) COMP_CWORD=2; _gapcheck; [ \"\${COMPREPLY[*]}\" = --config ] || exit 5
  source '${prefix}/share/bash-completion/completions/check-c'
  COMP_WORDS=(check-c -time) COMP_CWORD=1; _check_c; [ \"\${COMPREPLY[*]}\" = -timestep ] || exit 4")
file(READ ${prefix}/share/man/man1/gapcheck.1 page)
foreach(text "\n.SH gapcheck audit\n" "\n\\fB\\-\\-fail\\-on\\fR " "\n\\fB\\-\\-config\\fR " "\n.SH EXIT STATUS\n")
  string(FIND "${page}" "${text}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "the manual page lacks ${text}")
  endif()
endforeach()

step(${CMAKE_COMMAND} -S ${SOURCE}/tests/install/consumer -B ${WORK}/consumer -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${prefix}
     -DCMAKE_BUILD_TYPE=Release)
step(${CMAKE_COMMAND} --build ${WORK}/consumer)
step(${WORK}/consumer/consumer ${SOURCE}/data/two_plates.k)
if(NOT output STREQUAL "18 1006 0.3 18\n")
  message(FATAL_ERROR "the consumer prints: ${output}")
endif()
