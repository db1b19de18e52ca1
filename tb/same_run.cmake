# same_run(NAME program scenario [options...]): test NAME, de1sim and the program play the same.
function(same_run name program scenario)
    add_test(NAME ${name} COMMAND /usr/bin/python3 -B ${CMAKE_SOURCE_DIR}/tb/support/same_run.py
        $<TARGET_FILE:de1sim> $<TARGET_FILE:${program}> ${scenario}
        ${CMAKE_CURRENT_BINARY_DIR}/${name} ${ARGN})
    set_tests_properties(${name} PROPERTIES LABELS system TIMEOUT ${HANGS_LONG} COST 50)
endfunction()
