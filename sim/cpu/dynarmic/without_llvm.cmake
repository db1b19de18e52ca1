# without_llvm.cmake - a library in LLVM's place, because dynarmic needs none of LLVM here.
#
# dynarmic calls LLVM only to print the code that it translates, which nobody asks for here.  But to
# load LLVM, and Z3 and ICU which that needs, takes two thirds of the time in which de1sim starts:
# 400,000 relocations.  So there is a small library with LLVM's file name and the functions that
# dynarmic knows, each of which ends the process.  Programs are linked with it and so load it before
# dynarmic; the loader does not load a second library of the same name.  Where it does not find this
# one, as in a root without /proc, it loads LLVM itself, and all goes on as well.

execute_process(COMMAND ${CMAKE_OBJDUMP} -p ${DYNARMIC_LIBRARY}
    OUTPUT_VARIABLE needed COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_NM} -D --undefined-only ${DYNARMIC_LIBRARY}
    OUTPUT_VARIABLE undefined COMMAND_ERROR_IS_FATAL ANY)
if(NOT needed MATCHES "NEEDED +(libLLVM[^ \n]*)")
    return()  # this one was built without it
endif()
set(file ${CMAKE_MATCH_1})
string(REGEX MATCHALL "LLVM[A-Za-z0-9]+@[A-Za-z0-9_.]+" symbols "${undefined}")
list(GET symbols 0 version)
string(REGEX REPLACE ".*@" "" version ${version})

set(folder ${CMAKE_CURRENT_BINARY_DIR}/without_llvm)
set(source "#include <cstdlib>\nextern \"C\" {\n")
foreach(symbol ${symbols})
    string(REGEX REPLACE "@.*" "" name ${symbol})
    string(APPEND source "void ${name}() { std::abort(); }\n")
endforeach()
file(CONFIGURE OUTPUT ${folder}/without_llvm.cpp CONTENT "${source}}\n" @ONLY)
file(CONFIGURE OUTPUT ${folder}/exports.map @ONLY
    CONTENT "${version} { global: LLVM*; local: *; };\n")

add_library(without_llvm SHARED ${folder}/without_llvm.cpp)
target_link_options(without_llvm PRIVATE LINKER:--version-script=${folder}/exports.map)
set_target_properties(without_llvm PROPERTIES PREFIX "" OUTPUT_NAME ${file} SUFFIX ""
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/de1sim)
