set_module_property NAME altera_up_avalon_audio_pll
set_module_property ELABORATION_CALLBACK elaborate
add_parameter gui_refclk FLOAT 50.0
add_parameter audio_clk_freq FLOAT 12.288
add_parameter output_clock_frequency0 STRING "0 MHz"
set_parameter_property output_clock_frequency0 HDL_PARAMETER true
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_pll

add_interface ref_clk clock end
add_interface_port ref_clk refclk clk Input 1
add_interface ref_reset reset end
add_interface_port ref_reset rst reset Input 1
add_interface audio_clk clock start
add_interface_port audio_clk outclk_0 clk Output 1
add_interface reset_source reset start
add_interface_port reset_source not_locked reset Output 1

proc elaborate {} {
    set_parameter_value output_clock_frequency0 "[get_parameter_value audio_clk_freq] MHz"
}
