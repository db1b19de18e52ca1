set_module_property NAME altera_up_avalon_video_scaler
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    color_bits INTEGER 10   color_planes INTEGER 3   width_in INTEGER 320   height_in INTEGER 240
    width_scaling STRING 2  height_scaling STRING 2  include_channel BOOLEAN false
} { add_parameter $name $type $value }
foreach {name value} {BITS 30 WIDTH 320 HEIGHT 240 X 2 Y 2 X_LOST 1 Y_LOST 1} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_up_scaler

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_scaler_sink avalon_streaming end
add_interface avalon_scaler_source avalon_streaming start
foreach name {avalon_scaler_sink avalon_scaler_source} {
    set_interface_property $name associatedClock clk
    set_interface_property $name associatedReset reset
}

proc elaborate {} {
    set bits [expr {[get_parameter_value color_bits] * [get_parameter_value color_planes]}]
    foreach {name from size into} {X width_scaling WIDTH width_in Y height_scaling HEIGHT height_in} {
        set factor [get_parameter_value $from]
        set lost [lindex {4 2} [lsearch {0.25 0.5} $factor]]
        if {$lost eq "" && (![string is integer $factor] || $factor < 1 || $factor > 8)} {
            send_message error "$from is $factor, expected 0.25, 0.5 or a whole number of 1 to 8"
        }
        set_parameter_value $name [expr {$lost eq "" ? $factor : 1}]
        set_parameter_value ${name}_LOST [expr {$lost eq "" ? 1 : $lost}]
        set_parameter_value $size [get_parameter_value $into]
    }
    set_parameter_value BITS $bits
    foreach {interface port into against} {
        avalon_scaler_sink stream_in Input Output avalon_scaler_source stream_out Output Input
    } {
        foreach {role direction count} "
            data $into $bits startofpacket $into 1 endofpacket $into 1 valid $into 1
            ready $against 1
        " { add_interface_port $interface ${port}_$role $role $direction $count }
    }
    if {[string is true [get_parameter_value include_channel]]} {
        add_interface_port avalon_scaler_source stream_out_channel channel Output 6
    }
}
