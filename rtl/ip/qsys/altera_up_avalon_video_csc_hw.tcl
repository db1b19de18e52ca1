set_module_property NAME altera_up_avalon_video_csc
set_module_property ELABORATION_CALLBACK elaborate
add_parameter csc_type STRING {444 YCrCb to 24-bit RGB}
add_parameter KIND INTEGER 1
set_parameter_property KIND HDL_PARAMETER true
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_up_colors

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
proc stream {interface side port into against bits} {
    add_interface $interface avalon_streaming $side
    set_interface_property $interface associatedClock clk
    set_interface_property $interface associatedReset reset
    foreach {role direction count} "
        data $into $bits startofpacket $into 1 endofpacket $into 1 valid $into 1 ready $against 1
    " { add_interface_port $interface ${port}_$role $role $direction $count }
}

proc elaborate {} {
    set kinds {{24-bit RGB to 444 YCrCb} {444 YCrCb to 24-bit RGB} {24-bit RGB to Grayscale (Y)}
               {Grayscale (Y) to 24-bit RGB}}
    set type [get_parameter_value csc_type]
    set kind [lsearch -exact $kinds $type]
    if {$kind < 0} {
        send_message error "csc_type is \"$type\", expected one of: [join $kinds {, }]"
    }
    set_parameter_value KIND $kind
    stream avalon_csc_sink end stream_in Input Output [expr {$kind == 3 ? 8 : 24}]
    stream avalon_csc_source start stream_out Output Input [expr {$kind == 2 ? 8 : 24}]
}
