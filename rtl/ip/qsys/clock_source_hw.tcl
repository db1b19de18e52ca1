# A clock and a reset from outside.
set_module_property NAME clock_source
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_clock_source

add_interface clk_in clock end
add_interface_port clk_in in_clk clk Input 1
add_interface clk_in_reset reset end
add_interface_port clk_in_reset reset_n reset_n Input 1
add_interface clk clock start
set_interface_property clk associatedDirectClock clk_in
add_interface_port clk clk_out clk Output 1
add_interface clk_reset reset start
set_interface_property clk_reset associatedClock clk
add_interface_port clk_reset reset_n_out reset_n Output 1
