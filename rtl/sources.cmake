# sources.cmake - the files of fpga.v, for the simulator, the linters and synthesis.
set(RTL_SOURCES
    fpga.v
    bus/lw_bridge.v bus/lw_decode.v bus/h2f_bridge.v bus/axi_read.v bus/axi_write.v
    common/fifo.v common/sync.v
    gpio/output_port.v gpio/pio.v
    keypad/keypad.v keypad/keypad_scan.v
    sysid/sysid.v
    vga/vga.v vga/vga_timing.v vga/pixel_registers.v vga/picture_memory.v vga/picture_store.v
    audio/audio.v audio/audio_clocks.v audio/codec_setup.v audio/i2c_writer.v audio/i2s_rx.v
    audio/i2s_tx.v)
list(TRANSFORM RTL_SOURCES PREPEND ${CMAKE_SOURCE_DIR}/rtl/)
set(RTL_INCLUDES
    -I${CMAKE_SOURCE_DIR}/rtl/regmap -I${CMAKE_SOURCE_DIR}/rtl/bus -I${CMAKE_SOURCE_DIR}/rtl/vga)
