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
set_fileset_property synth TOP_LEVEL de1sim_up_dma

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_dma_master avalon start
add_interface avalon_dma_control_slave avalon end
add_interface avalon_pixel_source avalon_streaming start
foreach name {avalon_dma_master avalon_dma_control_slave avalon_pixel_source} {
    set_interface_property $name associatedClock clk
    set_interface_property $name associatedReset reset
}

proc bits_of {count} {
    set bits 0
    while {(1 << $bits) < $count} { incr bits }
    return $bits
}

proc elaborate {} {
    if {[get_parameter_value mode] ne "From Memory to Stream"} {
        send_message error "mode is \"[get_parameter_value mode]\", of which only From Memory to\
            Stream can be simulated"
    }
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
    foreach {name role direction count} "
        master_address address Output 32          master_read read Output 1
        master_arbiterlock lock Output 1          master_waitrequest waitrequest Input 1
        master_readdatavalid readdatavalid Input 1 master_readdata readdata Input [expr {8 * $bytes}]
    " { add_interface_port avalon_dma_master $name $role $direction $count }
    foreach {name role direction count} {
        slave_address address Input 2        slave_byteenable byteenable Input 4
        slave_read read Input 1              slave_write write Input 1
        slave_writedata writedata Input 32   slave_readdata readdata Output 32
    } { add_interface_port avalon_dma_control_slave $name $role $direction $count }
    foreach {role direction count} "
        ready Input 1 data Output $bits startofpacket Output 1 endofpacket Output 1 valid Output 1
    " { add_interface_port avalon_pixel_source stream_$role $role $direction $count }
}
