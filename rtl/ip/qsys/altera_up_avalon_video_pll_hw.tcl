set_module_property NAME altera_up_avalon_video_pll
set_module_property ELABORATION_CALLBACK elaborate
add_parameter gui_refclk FLOAT 50.0
add_parameter gui_resolution STRING "VGA 640x480"
add_parameter vga_clk_en BOOLEAN true
add_parameter video_in_clk_en BOOLEAN false
add_parameter lcd_clk_en BOOLEAN false
add_parameter camera STRING ""
add_parameter lcd STRING ""
foreach n {0 1 2} {
    add_parameter output_clock_frequency$n STRING "0 MHz"
    set_parameter_property output_clock_frequency$n HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_pll

add_interface ref_clk clock end
add_interface_port ref_clk refclk clk Input 1
add_interface ref_reset reset end
add_interface_port ref_reset rst reset Input 1
add_interface reset_source reset start
add_interface_port reset_source not_locked reset Output 1

proc output {n name mhz} {
    add_interface $name clock start
    add_interface_port $name outclk_$n clk Output 1
    set_parameter_value output_clock_frequency$n "$mhz MHz"
}

proc elaborate {} {
    array set mhz {"VGA 640x480" 25.0 "SVGA 800x600" 40.0 "XGA 1024x768" 65.0}
    set resolution [get_parameter_value gui_resolution]
    if {![info exists mhz($resolution)]} {
        send_message error "gui_resolution is $resolution, expected one of [array names mhz]"
    }
    if {[string is true [get_parameter_value vga_clk_en]]} { output 0 vga_clk $mhz($resolution) }
    if {[string is true [get_parameter_value video_in_clk_en]]} { output 1 video_in_clk 25.0 }
    if {[string is true [get_parameter_value lcd_clk_en]]} { output 2 lcd_clk 33.0 }
}
