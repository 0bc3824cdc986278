# Any step that fails ends the test.
function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${status}\n${output}\n${errors}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(prefix ${WORK}/prefix)
file(REMOVE_RECURSE ${prefix} ${WORK}/consumer ${WORK}/examples)
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
  COMP_WORDS=(gapcheck explain untied) COMP_CWORD=2; _gapcheck; [ \"\${COMPREPLY[*]}\" = untied-node ] || exit 6
  COMP_WORDS=(gapcheck audit --select untied) COMP_CWORD=3; _gapcheck; [ \"\${COMPREPLY[*]}\" = untied-node ] || exit 7
  COMP_WORDS=(gapcheck messag --select energy) COMP_CWORD=3; _gapcheck; [ \"\${COMPREPLY[*]}\" = energy-ratio ] || exit 8
  COMP_WORDS=(gapcheck audit --select energy) COMP_CWORD=3; _gapcheck; [ \"\${COMPREPLY[*]}\" = '' ] || exit 9
  source '${prefix}/share/bash-completion/completions/check-c'
  COMP_WORDS=(check-c -time) COMP_CWORD=1; _check_c; [ \"\${COMPREPLY[*]}\" = -timestep ] || exit 4")
file(READ ${prefix}/share/man/man1/gapcheck.1 page)
foreach(text "\n.SH gapcheck audit\n" "\n\\fB\\-\\-fail\\-on\\fR " "\n\\fB\\-\\-config\\fR " "\n.SH EXIT STATUS\n")
  string(FIND "${page}" "${text}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "the manual page lacks ${text}")
  endif()
endforeach()

# The public headers are all that there is to include.
file(GLOB public RELATIVE ${SOURCE}/lib/api ${SOURCE}/lib/api/gapcheck/*.hpp)
file(GLOB_RECURSE installed RELATIVE ${prefix}/include ${prefix}/include/*)
if(NOT "${installed}" STREQUAL "${public}" OR public STREQUAL "")
  message(FATAL_ERROR "installed headers: ${installed}\nexpected: ${public}")
endif()

# What only the rooms include need not be there for those who use the library.
set(absent "")
foreach(library Eigen3 CGAL nlohmann_json)
  list(APPEND absent -DCMAKE_DISABLE_FIND_PACKAGE_${library}=ON)
endforeach()
function(build_project folder name)
  step(${CMAKE_COMMAND} -S ${folder} -B ${WORK}/${name} -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${prefix}
       -DCMAKE_BUILD_TYPE=Release ${absent})
  step(${CMAKE_COMMAND} --build ${WORK}/${name})
endfunction()

build_project(${SOURCE}/tests/install/consumer consumer)
step(${WORK}/consumer/consumer ${SOURCE}/data/two_plates.k)
if(NOT output STREQUAL "18 1006 0.3 18 0\n")
  message(FATAL_ERROR "the consumer prints: ${output}")
endif()

# The examples need no more than that either.
build_project(${SOURCE}/examples examples)
step(${WORK}/examples/audit_deck ${SOURCE}/data/two_plates.k 1)
if(NOT output MATCHES "^penetrations: 18, contacts: 1\ncontact 1 node 1006 depth 0.3 ")
  message(FATAL_ERROR "the example prints: ${output}")
endif()
