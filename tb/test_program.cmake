# test_program.cmake - how a GoogleTest program and its tests are declared.

# Seconds after which a test hangs: at least ten times what it takes on a quiet machine.
set(HANGS 60)         # a test of functions or of one block
set(HANGS_RUN 600)    # one that runs de1sim or a tool
set(HANGS_LONG 1800)  # one that does so for minutes
if(DE1SIM_SANITIZE)   # where all is some times slower
    set(HANGS 600)
    set(HANGS_RUN 3600)
    set(HANGS_LONG 7200)
endif()

# test_program(NAME SOURCES... [LIBS libraries...] [HEADERS target]): one GoogleTest program.
#
# Compiling it takes longer than running it, so it is not optimised, and the headers that most
# of them include come compiled, from HEADERS of tb/support.  A test that forgets to include one
# is found by `make clang`, which is without.
set(TEST_OPTIMISATION -O0)
function(compile_as_test name headers)
    target_compile_options(${name} PRIVATE ${TEST_OPTIMISATION})
    target_precompile_headers(${name} REUSE_FROM ${headers})
    target_link_libraries(${name} PRIVATE warnings)
    target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR})
endfunction()
function(test_program name)
    cmake_parse_arguments(arg "" "HEADERS" "SOURCES;LIBS" ${ARGN})
    if(NOT arg_HEADERS)
        set(arg_HEADERS test_support)
    endif()
    add_executable(${name} ${arg_SOURCES})
    target_link_libraries(${name} PRIVATE ${arg_LIBS} GTest::gmock_main)
    compile_as_test(${name} ${arg_HEADERS})
endfunction()

# test_library(NAME sources...): what several of them share, compiled once.
function(test_library name)
    add_library(${name} STATIC ${ARGN})
    target_link_libraries(${name} PRIVATE GTest::gmock)
    compile_as_test(${name} test_support)
endfunction()

# de1_test(NAME LABEL [TIMEOUT seconds] [COST seconds] ...): a test_program() and its tests, of one
# CTest label.  CTest begins with those of the highest cost, so that no long one ends alone.
function(de1_test name label)
    cmake_parse_arguments(arg "" "TIMEOUT;COST" "" ${ARGN})
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT ${HANGS})
    endif()
    if(arg_COST)
        set(cost COST ${arg_COST})
    endif()
    test_program(${name} ${arg_UNPARSED_ARGUMENTS})
    gtest_discover_tests(${name} PROPERTIES LABELS ${label} TIMEOUT ${arg_TIMEOUT} ${cost}
        DISCOVERY_TIMEOUT ${HANGS_RUN})
endfunction()
