# sources.cmake - the files of fpga.v, and how a module of rtl/ becomes a Verilated class.

set(RTL_SOURCES
    fpga.v fpga_clocks.v
    adc/adc.v
    audio/audio.v audio/audio_serial.v audio/av_config.v audio/codec_setup.v audio/i2c_writer.v
    audio/i2s_rx.v audio/i2s_tx.v
    bus/axi_read.v bus/axi_write.v bus/h2f_bridge.v bus/lw_bridge.v bus/lw_decode.v
    common/countdown.v common/dual_clock_fifo.v common/fifo.v common/prescaler.v
    common/shift_fifo.v common/small_fifo.v common/sync.v
    gpio/hex_port.v gpio/output_port.v gpio/parallel_ports.v gpio/pio.v
    irda/irda.v irda/irda_rx.v irda/irda_tx.v
    jtag_uart/jtag_uart.v jtag_uart/jtag_uarts.v
    keypad/keypad.v keypad/keypad_scan.v
    onchip/onchip_memory.v onchip/onchip_store.v
    ps2/ps2_link.v ps2/ps2_port.v ps2/ps2_ports.v
    sdram/sdram.v sdram/sdram_controller.v
    sysid/sysid.v
    timer/interval_timer.v
    vga/character_store.v vga/line_buffer.v vga/pixel_dma.v vga/pixel_registers.v
    vga/screen_registers.v vga/vga.v vga/vga_timing.v vga/video.v
    video_in/bt656_rx.v video_in/sobel.v video_in/video_capture.v video_in/video_in.v
    video_in/video_writer.v video_in/write_turns.v video_in/ycbcr_to_rgb.v)
# Only on the board: pins, clock, processor.
set(BOARD_SOURCES
    board/de1_soc/audio_clock.v board/de1_soc/clock_reset.v board/de1_soc/de1_soc_top.v
    board/de1_soc/header.v board/de1_soc/hps.v board/de1_soc/jtag_terminals.v
    common/reset_sync.v)
set(RTL_INCLUDES regmap bus vga)

# What every Verilated class runs on, compiled once: verilate() would do so in each target.
set(RUNTIME_SOURCES verilated.cpp verilated_dpi.cpp verilated_threads.cpp)
if(DE1SIM_COVERAGE)
    list(APPEND RUNTIME_SOURCES verilated_cov.cpp)
endif()
list(TRANSFORM RUNTIME_SOURCES PREPEND ${VERILATOR_ROOT}/include/)
add_library(verilated_runtime STATIC ${RUNTIME_SOURCES})
target_include_directories(verilated_runtime SYSTEM PUBLIC ${VERILATOR_ROOT}/include
    ${VERILATOR_ROOT}/include/vltstd)
target_compile_definitions(verilated_runtime PUBLIC VL_TIME_CONTEXT)
target_link_libraries(verilated_runtime PUBLIC Threads::Threads)
target_compile_options(verilated_runtime PRIVATE -O1)  # hardly called while the model runs
if(DE1SIM_COVERAGE)
    target_sources(verilated_runtime PRIVATE
        ${CMAKE_SOURCE_DIR}/sim/fpga/write_coverage.cpp)
    target_compile_definitions(verilated_runtime PRIVATE
        COVERAGE_DATA="${CMAKE_BINARY_DIR}/coverage-data")
    target_link_options(verilated_runtime INTERFACE LINKER:--wrap=_ZN13VerilatedSymsD2Ev
        LINKER:--wrap=_ZN13VerilatedSymsC2EP16VerilatedContext)
endif()

# verilate_rtl(TARGET TOP [TRACE_FST] [FOR_TEST] [COVERAGE] SOURCES files under rtl/...
#     ARGS for Verilator...)
#
# Adds class V<TOP> to the target; FOR_TEST, where it runs for milliseconds, as one source, little
# optimised, and with the counters of `make coverage`, as with COVERAGE: they make a run six times
# as long.  Paths are relative, because Verilator 5.006 stumbles over blanks in those of its
# sources.
function(verilate_rtl target top)
    cmake_parse_arguments(arg "TRACE_FST;FOR_TEST;COVERAGE" "" "SOURCES;ARGS" ${ARGN})
    set(class V${top})
    file(RELATIVE_PATH rtl ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_SOURCE_DIR}/rtl)
    list(TRANSFORM arg_SOURCES PREPEND ${rtl}/)
    list(TRANSFORM RTL_INCLUDES PREPEND -I${rtl}/ OUTPUT_VARIABLE includes)
    if(arg_TRACE_FST)
        set(trace TRACE_FST)
    endif()
    if(DE1SIM_COVERAGE AND (arg_FOR_TEST OR arg_COVERAGE))
        set(coverage COVERAGE)
    endif()
    if(NOT DE1SIM_WERROR)  # each new Verilator finds something new
        set(warnings -Wno-fatal)
    endif()
    if(DE1SIM_SANITIZE)
        set(unchecked -fno-sanitize=all)  # not ours, and hot
    endif()
    if(arg_FOR_TEST)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
        target_compile_options(${target} PRIVATE -O1 ${unchecked})
    else()
        set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
        set(flags OPT_FAST ${unchecked} OPT_SLOW -O0 ${unchecked})  # slow: what runs once
    endif()
    # What was made from a file that is gone would ask for it in each configuration.
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/${class}.dir)
    set(made ${folder}/${class}_copy.cmake)
    include(${made} OPTIONAL)
    foreach(file ${${class}_DEPS})
        get_filename_component(file ${file} ABSOLUTE)
        if(NOT EXISTS ${file})
            file(REMOVE ${made})
        endif()
    endforeach()
    verilate(${target} ${trace} ${coverage} ${flags} PREFIX ${class} TOP_MODULE ${top}
        SOURCES ${arg_SOURCES} VERILATOR_ARGS -Wall ${warnings} ${includes} ${arg_ARGS})
    get_target_property(sources ${target} SOURCES)
    list(REMOVE_ITEM sources ${RUNTIME_SOURCES})
    set_target_properties(${target} PROPERTIES SOURCES "${sources}")
    target_link_libraries(${target} PUBLIC verilated_runtime)
    # What Verilator makes is not ours to warn about.
    target_include_directories(${target} SYSTEM PUBLIC ${folder})
endfunction()
