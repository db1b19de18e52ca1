set_module_property NAME altera_up_avalon_video_decoder
set_module_property ELABORATION_CALLBACK elaborate
add_parameter video_source STRING {On-board Video In (NTSC or PAL)}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_up_avalon_video_decoder

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_decoder_source avalon_streaming start
set_interface_property avalon_decoder_source associatedClock clk
set_interface_property avalon_decoder_source associatedReset reset
foreach {role direction bits} {
    data Output 16 startofpacket Output 1 endofpacket Output 1 valid Output 1 ready Input 1
} { add_interface_port avalon_decoder_source stream_out_$role $role $direction $bits }
add_interface external_interface conduit end
foreach {name direction bits} {
    TD_CLK27 Input 1     TD_DATA Input 8      TD_HS Input 1          TD_VS Input 1
    clk27_reset Input 1  TD_RESET Output 1    overflow_flag Output 1
} { add_interface_port external_interface $name $name $direction $bits }

proc elaborate {} {
    set source [get_parameter_value video_source]
    if {![string match {On-board*} $source]} {
        send_message error "video_source is \"$source\", of which only On-board Video In (NTSC or PAL)\
            can be simulated: no camera can be plugged in"
    }
}
