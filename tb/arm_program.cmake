# arm_program.cmake - programs for the board's processor, built beside the tests that run them.

find_program(ARM_GCC arm-none-eabi-gcc REQUIRED)

# arm_program(NAME SOURCES files... FLAGS ... [DEPENDS headers, linker scripts...]): NAME.elf in the
# binary folder, by target NAME; its path goes into NAME_ELF.
function(arm_program name)
    cmake_parse_arguments(arg "" "" "SOURCES;FLAGS;DEPENDS" ${ARGN})
    set(elf ${CMAKE_CURRENT_BINARY_DIR}/${name}.elf)
    list(TRANSFORM arg_DEPENDS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
    list(TRANSFORM arg_SOURCES PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
    add_custom_command(OUTPUT ${elf}
        COMMAND ${ARM_GCC} -mcpu=cortex-a9 -mfpu=neon -mfloat-abi=softfp -g -O1 -ffreestanding
            -Wall -Wextra ${WERROR} ${arg_SOURCES} ${arg_FLAGS} -Wl,--build-id=none
            -Wl,--no-warn-rwx-segments -o ${elf}
        DEPENDS ${arg_SOURCES} ${arg_DEPENDS} VERBATIM)
    add_custom_target(${name} ALL DEPENDS ${elf})
    set(${name}_ELF ${elf} PARENT_SCOPE)
endfunction()
