set_module_property NAME altera_up_avalon_video_change_alpha
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value} {color_bits 10 color_planes 4 color 0 alpha 0 BITS 40 COLOR 0 ALPHA 0} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER [string is upper $name]
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_up_avalon_video_change_alpha

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_apply_alpha_sink avalon_streaming end
add_interface avalon_apply_alpha_source avalon_streaming start
foreach name {avalon_apply_alpha_sink avalon_apply_alpha_source} {
    set_interface_property $name associatedClock clk
    set_interface_property $name associatedReset reset
}

proc elaborate {} {
    set bits [expr {[get_parameter_value color_bits] * [get_parameter_value color_planes]}]
    set_parameter_value BITS $bits
    set_parameter_value COLOR [get_parameter_value color]
    set_parameter_value ALPHA [get_parameter_value alpha]
    foreach {interface port into against} {
        avalon_apply_alpha_sink stream_in Input Output
        avalon_apply_alpha_source stream_out Output Input
    } {
        foreach {role direction count} "
            data $into $bits startofpacket $into 1 endofpacket $into 1 valid $into 1
            ready $against 1
        " { add_interface_port $interface ${port}_$role $role $direction $count }
    }
}
