set_module_property NAME altera_up_avalon_video_dma_controller
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    addr_mode STRING X-Y    start_address LONG 0   back_start_address LONG 0  width INTEGER 640
    height INTEGER 480      color_bits INTEGER 8   color_planes INTEGER 3     dma_enabled BOOLEAN true
    mode STRING {From Memory to Stream}
} { add_parameter $name $type $value }
foreach {name value} {
    WIDTH 640 HEIGHT 480 BITS 16 BYTES 2 CONSECUTIVE 0 X_BITS 10 Y_BITS 9 ENABLED 1
} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
foreach name {START BACK} {
    add_parameter $name LONG 0
    set_parameter_property $name HDL_PARAMETER true
    set_parameter_property $name WIDTH 32
}
add_fileset synth QUARTUS_SYNTH "" ""

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_dma_master avalon start
add_interface avalon_dma_control_slave avalon end
foreach name {avalon_dma_master avalon_dma_control_slave} {
    set_interface_property $name associatedClock clk
    set_interface_property $name associatedReset reset
}

proc bits_of {count} {
    set bits 0
    while {(1 << $bits) < $count} { incr bits }
    return $bits
}

proc elaborate {} {
    set mode [get_parameter_value mode]
    set writes [expr {$mode eq "From Stream to Memory"}]
    if {!$writes && $mode ne "From Memory to Stream"} {
        send_message error "mode is \"$mode\", expected From Memory to Stream, or From Stream to\
            Memory"
    }
    set_fileset_property synth TOP_LEVEL [expr {$writes ? "de1sim_up_dma_to_memory"
                                                        : "de1sim_up_dma"}]
    set bits [expr {[get_parameter_value color_bits] * [get_parameter_value color_planes]}]
    set_parameter_value ENABLED [string is true [get_parameter_value dma_enabled]]
    set bytes [expr {$bits <= 8 ? 1 : $bits <= 16 ? 2 : 4}]
    set width [get_parameter_value width]
    set height [get_parameter_value height]
    foreach {name value} [list WIDTH $width HEIGHT $height BITS $bits BYTES $bytes \
                              CONSECUTIVE [expr {[get_parameter_value addr_mode] ne "X-Y"}] \
                              X_BITS [bits_of $width] Y_BITS [bits_of $height] \
                              START [get_parameter_value start_address] \
                              BACK [get_parameter_value back_start_address]] {
        set_parameter_value $name $value
    }
    set width [expr {8 * $bytes}]
    add_interface_port avalon_dma_master master_address address Output 32
    foreach {name direction count} [expr {$writes ? "write Output 1 writedata Output $width"
        : "read Output 1 arbiterlock Output 1 readdatavalid Input 1 readdata Input $width"}] {
        set role [expr {$name eq "arbiterlock" ? "lock" : $name}]
        add_interface_port avalon_dma_master master_$name $role $direction $count
    }
    add_interface_port avalon_dma_master master_waitrequest waitrequest Input 1
    foreach {name role direction count} {
        slave_address address Input 2        slave_byteenable byteenable Input 4
        slave_read read Input 1              slave_write write Input 1
        slave_writedata writedata Input 32   slave_readdata readdata Output 32
    } { add_interface_port avalon_dma_control_slave $name $role $direction $count }
    set stream [expr {$writes ? "avalon_dma_sink" : "avalon_pixel_source"}]
    lassign [expr {$writes ? "Input Output end" : "Output Input start"}] into against side
    add_interface $stream avalon_streaming $side
    set_interface_property $stream associatedClock clk
    set_interface_property $stream associatedReset reset
    foreach {role direction count} "
        ready $against 1 data $into $bits startofpacket $into 1 endofpacket $into 1 valid $into 1
    " { add_interface_port $stream stream_$role $role $direction $count }
}
