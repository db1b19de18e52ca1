# version.cmake - writes VERSION_FILE, the definition of sim::VERSION, where it is not current
#
# Called in each build, because the commit changes without CMake's being called.

execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --exclude=*
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
set(facts ${OPTIONS})
if(commit)
    list(PREPEND facts "commit ${commit}")
endif()
list(JOIN facts ", " facts)
file(CONFIGURE OUTPUT ${VERSION_FILE} CONTENT [=[#include "sim/run/version.h"

const char* const sim::VERSION = "de1sim @VERSION@ (@facts@)";
]=] @ONLY)
