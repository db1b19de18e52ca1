# arm_core.cmake - the engine behind arm_core.h: dynarmic, or Unicorn where that is missing.

# Not by dynarmic's CMake package, which asks for all that LLVM's needs and this project does not.
find_path(DYNARMIC_INCLUDE_DIR dynarmic/interface/A32/a32.h)
find_library(DYNARMIC_LIBRARY dynarmic)
pkg_check_modules(Unicorn IMPORTED_TARGET unicorn>=2.0.1)

if(DYNARMIC_INCLUDE_DIR AND DYNARMIC_LIBRARY)
    set(default_engine dynarmic)
else()
    set(default_engine unicorn)
endif()
set(DE1SIM_ARM_ENGINE ${default_engine} CACHE STRING "dynarmic, or unicorn, which is slower")

add_library(arm_core STATIC)
target_include_directories(arm_core PUBLIC ${CMAKE_SOURCE_DIR})
target_link_libraries(arm_core PRIVATE warnings_strict)
if(DE1SIM_ARM_ENGINE STREQUAL dynarmic)
    target_sources(arm_core PRIVATE
        hps/dynarmic/absent.cpp hps/dynarmic/code.cpp hps/dynarmic/core.cpp
        hps/dynarmic/cp15.cpp hps/dynarmic/data.cpp hps/dynarmic/direct.cpp
        hps/dynarmic/fetch.cpp hps/dynarmic/instructions.cpp hps/dynarmic/memory_map.cpp
        hps/dynarmic/modes.cpp hps/dynarmic/multiples.cpp hps/dynarmic/page_table.cpp
        hps/dynarmic/registers.cpp hps/dynarmic/steps.cpp hps/dynarmic/system.cpp
        hps/dynarmic/translation_tables.cpp)
    target_include_directories(arm_core SYSTEM PRIVATE ${DYNARMIC_INCLUDE_DIR})
    target_link_libraries(arm_core PRIVATE ${DYNARMIC_LIBRARY})
elseif(DE1SIM_ARM_ENGINE STREQUAL unicorn)
    if(NOT Unicorn_FOUND)
        message(FATAL_ERROR "An engine for the ARM processor is needed: libdynarmic-dev, or "
            "libunicorn-dev, which is slower.")
    endif()
    message(STATUS "--cpu arm runs on Unicorn; with libdynarmic-dev it is many times faster.")
    target_sources(arm_core PRIVATE
        hps/unicorn/core.cpp hps/unicorn/memory.cpp hps/unicorn/registers.cpp)
    target_link_libraries(arm_core PRIVATE PkgConfig::Unicorn)
else()
    message(FATAL_ERROR "DE1SIM_ARM_ENGINE is \"${DE1SIM_ARM_ENGINE}\": dynarmic or unicorn?")
endif()
