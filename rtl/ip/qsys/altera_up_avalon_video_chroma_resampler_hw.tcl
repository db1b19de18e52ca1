set_module_property NAME altera_up_avalon_video_chroma_resampler
set_module_property ELABORATION_CALLBACK elaborate
add_parameter input_type STRING {YCrCb 422}
add_parameter output_type STRING {YCrCb 444}
foreach {name value} {IN 16 OUT 24} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_up_chroma

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_chroma_sink avalon_streaming end
add_interface avalon_chroma_source avalon_streaming start
foreach name {avalon_chroma_sink avalon_chroma_source} {
    set_interface_property $name associatedClock clk
    set_interface_property $name associatedReset reset
}

proc elaborate {} {
    foreach {name from interface port into against} {
        IN input_type avalon_chroma_sink stream_in Input Output
        OUT output_type avalon_chroma_source stream_out Output Input
    } {
        set format [get_parameter_value $from]
        set bits [lindex {24 16 8} [lsearch {{YCrCb 444} {YCrCb 422} {Y only}} $format]]
        if {$bits eq ""} {
            send_message error "$from is \"$format\", expected YCrCb 444, YCrCb 422 or Y only"
        }
        set_parameter_value $name $bits
        foreach {role direction count} "
            data $into $bits startofpacket $into 1 endofpacket $into 1 valid $into 1
            ready $against 1
        " { add_interface_port $interface ${port}_$role $role $direction $count }
    }
}
