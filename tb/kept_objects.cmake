# kept_objects.cmake - keeps what is compiled of the tool.  A chapter of the guide builds it once
# more, from a changed copy, and takes from here the objects of what it has not changed.
#
# Where CCACHE_DIR is set when CMake first runs, the tests' objects are kept as well, all in that
# folder: CI hands it from one push to the next.
#
# -Werror makes no other object: the chapter's build, like every user's, is without.

find_program(CCACHE ccache REQUIRED)
set(DE1SIM_KEPT_OBJECTS "$ENV{CCACHE_DIR}" CACHE PATH "ccache's folder for all objects")
set(KEPT_OBJECTS CCACHE_DIR=${CMAKE_BINARY_DIR}/kept_objects)
if(DE1SIM_KEPT_OBJECTS)
    set(KEPT_OBJECTS CCACHE_DIR=${DE1SIM_KEPT_OBJECTS})
endif()
list(APPEND KEPT_OBJECTS CCACHE_IGNOREOPTIONS=-Werror
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime,locale)
if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env ${KEPT_OBJECTS}
        CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} ${CCACHE})
endif()
