set_module_property NAME altera_up_avalon_video_ascii_to_image
set_module_property VALIDATION_CALLBACK validate
add_parameter colour_format STRING {1-bit Black/White}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_up_avalon_video_ascii_to_image

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
foreach {name end port into against bits} {
    avalon_ascii_sink end ascii_in Input Output 8 avalon_image_source start image_out Output Input 1
} {
    add_interface $name avalon_streaming $end
    set_interface_property $name associatedClock clk
    set_interface_property $name associatedReset reset
    foreach {role direction count} "
        data $into $bits startofpacket $into 1 endofpacket $into 1 valid $into 1 ready $against 1
    " { add_interface_port $name ${port}_$role $role $direction $count }
}
add_interface_port avalon_ascii_sink ascii_in_channel channel Input 6

proc validate {} {
    if {![string match 1-bit* [get_parameter_value colour_format]]} {
        send_message error "colour_format is \"[get_parameter_value colour_format]\", expected\
            1-bit Black/White"
    }
}
