# sources.cmake - the files of fpga.v as the simulation has them

# LEAPING_SOURCES leave out clocks in which nothing happens (rtl/SLEEP.md): these modules take the
# place of those in rtl/.  With them go a root_clock.v and a group_clock.v.
set(twins fpga_clocks.v common/countdown.v common/prescaler.v timer/interval_timer.v
    vga/line_buffer.v vga/vga.v vga/vga_timing.v)
set(own fpga_clocks.v inside.v countdown.v interval_timer.v prescaler.v line_buffer.v vga.v
    vga_timing.v)
list(TRANSFORM own PREPEND ../sim/fpga/)
set(LEAPING_SOURCES ${RTL_SOURCES} ${own})
list(REMOVE_ITEM LEAPING_SOURCES ${twins})
