set_module_property NAME altera_up_avalon_video_character_buffer_with_dma
set_module_property ELABORATION_CALLBACK elaborate
add_parameter resolution STRING {80 x 60}
add_parameter enable_transparency BOOLEAN true
add_parameter color_bits STRING 1-bit
foreach {name value} {COLUMNS 80 LINES 60 BITS 40} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_up_characters

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_char_buffer_slave avalon end
add_interface avalon_char_control_slave avalon end
add_interface avalon_char_source avalon_streaming start
foreach name {avalon_char_buffer_slave avalon_char_control_slave avalon_char_source} {
    set_interface_property $name associatedClock clk
    set_interface_property $name associatedReset reset
}
foreach {role direction bits} {
    address Input 13 byteenable Input 1 chipselect Input 1 read Input 1 write Input 1
    writedata Input 8 readdata Output 8 waitrequest Output 1
} { add_interface_port avalon_char_buffer_slave buf_$role $role $direction $bits }
foreach {role direction bits} {
    address Input 1 byteenable Input 4 chipselect Input 1 read Input 1 write Input 1
    writedata Input 32 readdata Output 32
} { add_interface_port avalon_char_control_slave ctrl_$role $role $direction $bits }

proc elaborate {} {
    if {[get_parameter_value color_bits] ne "1-bit"} {
        send_message error "color_bits is \"[get_parameter_value color_bits]\", expected 1-bit"
    }
    scan [get_parameter_value resolution] "%d x %d" columns lines
    set bits [expr {[string is true [get_parameter_value enable_transparency]] ? 40 : 30}]
    foreach {name value} [list COLUMNS $columns LINES $lines BITS $bits] {
        set_parameter_value $name $value
    }
    foreach {role direction count} "
        ready Input 1 data Output $bits startofpacket Output 1 endofpacket Output 1 valid Output 1
    " { add_interface_port avalon_char_source stream_$role $role $direction $count }
}
