set_module_property NAME alt_vip_vfr
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value} {
    BITS_PER_PIXEL_PER_COLOR_PLANE 8 NUMBER_OF_CHANNELS_IN_PARALLEL 3 MEM_PORT_WIDTH 256
    RMASTER_FIFO_DEPTH 64 RMASTER_BURST_TARGET 32 BURST_BITS 6
    MAX_IMAGE_WIDTH 640 MAX_IMAGE_HEIGHT 480
} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
foreach {name value} {NUMBER_OF_CHANNELS_IN_SEQUENCE 1 CLOCKS_ARE_SEPARATE 1} { add_parameter $name INTEGER $value }
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL alt_vip_vfr

foreach {name clock reset} {
    clock_reset clock reset   clock_master master_clock master_reset
} {
    add_interface $name clock end
    add_interface_port $name $clock clk Input 1
    add_interface ${name}_reset reset end
    set_interface_property ${name}_reset associatedClock $name
    add_interface_port ${name}_reset $reset reset Input 1
}
add_interface avalon_slave avalon end
set_interface_property avalon_slave readLatency 1
set_interface_property avalon_slave readWaitTime 0
foreach {name role direction bits} {
    slave_address address Input 5      slave_write write Input 1
    slave_writedata writedata Input 32 slave_read read Input 1
    slave_readdata readdata Output 32
} { add_interface_port avalon_slave $name $role $direction $bits }
add_interface interrupt_sender interrupt end
add_interface_port interrupt_sender slave_irq irq Output 1
add_interface avalon_streaming_source avalon_streaming start
set_interface_property avalon_streaming_source readyLatency 1
add_interface avalon_master avalon start
foreach {name clock} {
    avalon_slave clock_reset             interrupt_sender clock_reset
    avalon_streaming_source clock_reset  avalon_master clock_master
} {
    set_interface_property $name associatedClock $clock
    set_interface_property $name associatedReset ${clock}_reset
}

proc elaborate {} {
    set bits [expr {[get_parameter_value BITS_PER_PIXEL_PER_COLOR_PLANE]
                    * [get_parameter_value NUMBER_OF_CHANNELS_IN_PARALLEL]}]
    set width [get_parameter_value MEM_PORT_WIDTH]
    if {$bits > $width} {
        send_message error "a pixel has $bits bits, expected at most the memory's $width"
    }
    set burst 1
    while {1 << $burst <= [get_parameter_value RMASTER_BURST_TARGET]} { incr burst }
    set_parameter_value BURST_BITS $burst
    foreach {name role direction count} "
        dout_ready ready Input 1                  dout_valid valid Output 1
        dout_data data Output $bits               dout_startofpacket startofpacket Output 1
        dout_endofpacket endofpacket Output 1
    " { add_interface_port avalon_streaming_source $name $role $direction $count }
    foreach {name role direction count} "
        master_address address Output 32          master_burstcount burstcount Output $burst
        master_read read Output 1                 master_readdata readdata Input $width
        master_readdatavalid readdatavalid Input 1 master_waitrequest waitrequest Input 1
    " { add_interface_port avalon_master $name $role $direction $count }
}
