# kept_objects.cmake - keeps what is compiled of the tool.  A chapter of the guide builds it once
# more, from a changed copy, and takes from here the objects of what it has not changed.

find_program(CCACHE ccache REQUIRED)
set(KEPT_OBJECTS CCACHE_DIR=${CMAKE_BINARY_DIR}/kept_objects
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime,locale)
if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env ${KEPT_OBJECTS}
        CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} ${CCACHE})
endif()
