set_module_property NAME altera_up_avalon_video_vga_controller
set_module_property ELABORATION_CALLBACK elaborate
add_parameter board STRING DE1-SoC
add_parameter device STRING {VGA Connector}
add_parameter resolution STRING {VGA 640x480}
foreach name {H_SHOWN H_FRONT H_SYNC H_BACK V_SHOWN V_FRONT V_SYNC V_BACK POSITIVE} {
    add_parameter $name INTEGER 0
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_up_avalon_video_vga_controller

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_vga_sink avalon_streaming end
set_interface_property avalon_vga_sink associatedClock clk
set_interface_property avalon_vga_sink associatedReset reset
foreach {name direction bits} {
    data Input 30 startofpacket Input 1 endofpacket Input 1 valid Input 1 ready Output 1
} { add_interface_port avalon_vga_sink $name $name $direction $bits }
add_interface external_interface conduit end
foreach {name bits} {CLK 1 HS 1 VS 1 BLANK 1 SYNC 1 R 8 G 8 B 8} {
    add_interface_port external_interface VGA_$name $name Output $bits
}

proc elaborate {} {
    set timings {
        {VGA 640x480} {640 16 96 48 480 10 2 33 0}      {SVGA 800x600} {800 40 128 88 600 1 4 23 1}
        {XGA 1024x768} {1024 24 136 160 768 3 6 29 0}   {SXGA 1280x1024} {1280 48 112 248 1024 1 3 38 1}
    }
    set resolution [get_parameter_value resolution]
    if {![dict exists $timings $resolution] || [get_parameter_value device] ne "VGA Connector"} {
        send_message error "it is for the [get_parameter_value device] with $resolution, expected\
            the VGA Connector with one of [join [dict keys $timings] {, }]"
    }
    foreach value [dict get $timings $resolution] \
        name {H_SHOWN H_FRONT H_SYNC H_BACK V_SHOWN V_FRONT V_SYNC V_BACK POSITIVE} {
        set_parameter_value $name $value
    }
}
