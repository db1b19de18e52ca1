set_module_property NAME altera_up_avalon_video_edge_detection
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value} {width 720 intensity 1 WIDTH 720} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER [expr {$name eq "WIDTH"}]
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_up_avalon_video_edge_detection

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
foreach {interface side port into against} {
    avalon_edge_detection_sink end in Input Output
    avalon_edge_detection_source start out Output Input
} {
    add_interface $interface avalon_streaming $side
    set_interface_property $interface associatedClock clk
    set_interface_property $interface associatedReset reset
    foreach {role direction count} "
        data $into 8 startofpacket $into 1 endofpacket $into 1 valid $into 1 ready $against 1
    " { add_interface_port $interface ${port}_$role $role $direction $count }
}

proc elaborate {} { set_parameter_value WIDTH [get_parameter_value width] }
