set_module_property NAME altera_up_avalon_video_rgb_resampler
set_module_property ELABORATION_CALLBACK elaborate
add_parameter input_type STRING {16-bit RGB}
add_parameter output_type STRING {30-bit RGB}
foreach {name value} {alpha 1023 FROM 16 TO 30 IN 16 OUT 30 ALPHA 1023} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER [expr {$name ne "alpha"}]
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_up_resampler

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_rgb_slave avalon end
add_interface avalon_rgb_sink avalon_streaming end
add_interface avalon_rgb_source avalon_streaming start
foreach name {avalon_rgb_slave avalon_rgb_sink avalon_rgb_source} {
    set_interface_property $name associatedClock clk
    set_interface_property $name associatedReset reset
}
add_interface_port avalon_rgb_slave slave_read read Input 1
add_interface_port avalon_rgb_slave slave_readdata readdata Output 32

# As de1sim_up_resampler.v names a format, and its bits.
proc format_of {name} {
    set bits [lindex [split $name -] 0]
    set format $bits
    if {$name eq "8-bit RGB"} { set format -8 }
    if {$name eq "16-bit RGBA"} { set format 17 }
    return [list $format $bits]
}

proc elaborate {} {
    lassign [format_of [get_parameter_value input_type]] from in
    lassign [format_of [get_parameter_value output_type]] to out
    foreach {name value} [list FROM $from TO $to IN $in OUT $out \
                              ALPHA [get_parameter_value alpha]] { set_parameter_value $name $value }
    foreach {interface port into against bits} "
        avalon_rgb_sink stream_in Input Output $in avalon_rgb_source stream_out Output Input $out
    " {
        foreach {role direction count} "
            data $into $bits startofpacket $into 1 endofpacket $into 1 valid $into 1
            ready $against 1
        " { add_interface_port $interface ${port}_$role $role $direction $count }
    }
}
