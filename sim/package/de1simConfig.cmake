# find_package(de1sim) gives
#
#   de1sim_program(NAME sources... [LIBS ...])
#
# an executable NAME that is de1sim with another firmware than the demo, and NAME-trace, which NAME
# starts for --trace.  The sources define main():
#
#   #include "sim/program.h"
#   int main(int argc, char** argv) { return sim::program(argc, argv, my_firmware); }

include(${CMAKE_CURRENT_LIST_DIR}/de1sim-targets.cmake)

function(de1sim_program name)
    cmake_parse_arguments(arg "" "" "LIBS" ${ARGN})
    add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
    target_link_libraries(${name} PRIVATE de1sim::library ${arg_LIBS})
    add_executable(${name}-trace ${arg_UNPARSED_ARGUMENTS})
    target_link_libraries(${name}-trace PRIVATE de1sim::library_trace ${arg_LIBS})
    add_dependencies(${name} ${name}-trace)
endfunction()
