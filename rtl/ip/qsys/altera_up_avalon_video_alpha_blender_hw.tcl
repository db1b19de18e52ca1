set_module_property NAME altera_up_avalon_video_alpha_blender
set_module_property ELABORATION_CALLBACK elaborate
add_parameter mode STRING Simple
add_parameter SIMPLE INTEGER 1
set_parameter_property SIMPLE HDL_PARAMETER true
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_up_blender

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
foreach {name end port into against bits} {
    avalon_background_sink end background Input Output 30
    avalon_foreground_sink end foreground Input Output 40
    avalon_blended_source start output Output Input 30
} {
    add_interface $name avalon_streaming $end
    set_interface_property $name associatedClock clk
    set_interface_property $name associatedReset reset
    foreach {role direction count} "
        data $into $bits startofpacket $into 1 endofpacket $into 1 valid $into 1 ready $against 1
    " { add_interface_port $name ${port}_$role $role $direction $count }
}

proc elaborate {} { set_parameter_value SIMPLE [expr {[get_parameter_value mode] eq "Simple"}] }
