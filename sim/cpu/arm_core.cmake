# arm_core.cmake - the engine behind arm_core.h: dynarmic, or Unicorn where that is missing.

# Not by dynarmic's CMake package, which asks for all that LLVM's needs and this project does not.
find_path(DYNARMIC_INCLUDE_DIR dynarmic/interface/A32/a32.h)
find_library(DYNARMIC_LIBRARY dynarmic)
pkg_check_modules(Unicorn IMPORTED_TARGET unicorn>=2.0.1)

# What dynarmic 6.7 makes for Arm machines is wrong: a Thumb store of another value, unaligned LDREX
# without an abort (arm_core_test on Debian 13 arm64, by qemu-user and on qemu's whole machine).
if(DYNARMIC_INCLUDE_DIR AND DYNARMIC_LIBRARY AND
        NOT CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch|arm)64")
    set(default_engine dynarmic)
else()
    set(default_engine unicorn)
endif()
set(DE1SIM_ARM_ENGINE ${default_engine} CACHE STRING "dynarmic, or unicorn, which is slower")

add_library(arm_core STATIC transferred_words.cpp)
target_include_directories(arm_core PUBLIC ${CMAKE_SOURCE_DIR})
target_link_libraries(arm_core PRIVATE warnings_strict)
if(DE1SIM_ARM_ENGINE STREQUAL dynarmic)
    target_sources(arm_core PRIVATE
        dynarmic/absent.cpp dynarmic/alignment.cpp dynarmic/arm_core.cpp dynarmic/code.cpp
        dynarmic/code_reader.cpp dynarmic/cp15.cpp dynarmic/data_access.cpp dynarmic/direct.cpp
        dynarmic/engine.cpp dynarmic/instructions.cpp dynarmic/memory_map.cpp dynarmic/mmu.cpp
        dynarmic/modes.cpp dynarmic/page_table.cpp dynarmic/saturating.cpp dynarmic/steps.cpp
        dynarmic/system_instructions.cpp dynarmic/system_registers.cpp
        dynarmic/system_transfers.cpp dynarmic/translated_code.cpp dynarmic/translation_tables.cpp)
    target_include_directories(arm_core SYSTEM PRIVATE ${DYNARMIC_INCLUDE_DIR})
    target_link_libraries(arm_core PRIVATE ${DYNARMIC_LIBRARY})
elseif(DE1SIM_ARM_ENGINE STREQUAL unicorn)
    if(NOT Unicorn_FOUND)
        message(FATAL_ERROR "An engine for the ARM processor is needed: libdynarmic-dev, or "
            "libunicorn-dev, which is slower.")
    endif()
    message(STATUS "--cpu arm runs on Unicorn, which is many times slower than dynarmic on x86-64.")
    target_sources(arm_core PRIVATE
        unicorn/core.cpp unicorn/memory.cpp unicorn/registers.cpp)
    target_link_libraries(arm_core PRIVATE PkgConfig::Unicorn)
else()
    message(FATAL_ERROR "DE1SIM_ARM_ENGINE is \"${DE1SIM_ARM_ENGINE}\": dynarmic or unicorn?")
endif()
