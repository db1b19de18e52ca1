set_module_property NAME altera_up_avalon_video_dual_clock_buffer
set_module_property ELABORATION_CALLBACK elaborate
add_parameter color_bits INTEGER 10
add_parameter color_planes INTEGER 3
add_parameter BITS INTEGER 30
set_parameter_property BITS HDL_PARAMETER true
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_up_crossing

foreach side {in out} {
    add_interface clock_stream_$side clock end
    add_interface_port clock_stream_$side clk_stream_$side clk Input 1
    add_interface reset_stream_$side reset end
    set_interface_property reset_stream_$side associatedClock clock_stream_$side
    add_interface_port reset_stream_$side reset_stream_$side reset Input 1
}
add_interface avalon_dc_buffer_sink avalon_streaming end
set_interface_property avalon_dc_buffer_sink associatedClock clock_stream_in
add_interface avalon_dc_buffer_source avalon_streaming start
set_interface_property avalon_dc_buffer_source associatedClock clock_stream_out

proc elaborate {} {
    set bits [expr {[get_parameter_value color_bits] * [get_parameter_value color_planes]}]
    set_parameter_value BITS $bits
    foreach {interface port into against} {
        avalon_dc_buffer_sink stream_in Input Output avalon_dc_buffer_source stream_out Output Input
    } {
        foreach {role direction count} "
            data $into $bits startofpacket $into 1 endofpacket $into 1 valid $into 1
            ready $against 1
        " { add_interface_port $interface ${port}_$role $role $direction $count }
    }
}
