# pgo.cmake - builds build/pgo/bin/de1sim with a profile of itself drawing a hundred shapes
#
# Two builds in one folder, so that the compiler finds each object's profile beside it.

set(source ${CMAKE_CURRENT_LIST_DIR}/..)
set(build ${source}/build/pgo)

function(step)
    execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(GLOB_RECURSE old ${build}/*.gcda)
if(old)
    file(REMOVE ${old})
endif()
step(${CMAKE_COMMAND} -S ${source} -B ${build} -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DDE1SIM_PGO=generate)
step(${CMAKE_COMMAND} --build ${build} --target de1sim)
step(${build}/bin/de1sim run ${source}/tb/bench/hundred.yaml --out ${build}/training --quiet)
step(${CMAKE_COMMAND} -S ${source} -B ${build} -DDE1SIM_PGO=use)
step(${CMAKE_COMMAND} --build ${build} --target de1sim)
message("${build}/bin/de1sim is the fast one")
