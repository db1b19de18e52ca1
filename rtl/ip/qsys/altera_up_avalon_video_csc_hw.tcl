set_module_property NAME altera_up_avalon_video_csc
set_module_property ELABORATION_CALLBACK elaborate
add_parameter csc_type STRING {444 YCrCb to 24-bit RGB}
add_parameter TO_RGB INTEGER 1
set_parameter_property TO_RGB HDL_PARAMETER true
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_up_colors

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
foreach {interface side port into against} {
    avalon_csc_sink end stream_in Input Output avalon_csc_source start stream_out Output Input
} {
    add_interface $interface avalon_streaming $side
    set_interface_property $interface associatedClock clk
    set_interface_property $interface associatedReset reset
    foreach {role direction count} "
        data $into 24 startofpacket $into 1 endofpacket $into 1 valid $into 1 ready $against 1
    " { add_interface_port $interface ${port}_$role $role $direction $count }
}

proc elaborate {} {
    set type [get_parameter_value csc_type]
    if {![string match *YCrCb* $type] || ![string match *RGB* $type]} {
        send_message error "csc_type is \"$type\", expected 444 YCrCb to 24-bit RGB, or the reverse"
    }
    set_parameter_value TO_RGB [expr {[string first YCrCb $type] < [string first RGB $type]}]
}
