# The SDRAM's clock leads by 3 ns on the boards with a Cyclone V, and those before it.
set_module_property NAME altera_up_avalon_sys_sdram_pll
set_module_property ELABORATION_CALLBACK elaborate
add_parameter gui_refclk FLOAT 50.0
add_parameter gui_outclk FLOAT 100.0
foreach n {0 1} {
    foreach name {output_clock_frequency phase_shift} {
        add_parameter $name$n STRING "0 ps"
        set_parameter_property $name$n HDL_PARAMETER true
    }
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_pll

add_interface ref_clk clock end
add_interface_port ref_clk refclk clk Input 1
add_interface ref_reset reset end
add_interface_port ref_reset rst reset Input 1
add_interface sys_clk clock start
add_interface_port sys_clk outclk_0 clk Output 1
add_interface sdram_clk clock start
add_interface_port sdram_clk outclk_1 clk Output 1
add_interface reset_source reset start
add_interface_port reset_source not_locked reset Output 1

proc elaborate {} {
    set mhz [get_parameter_value gui_outclk]
    set_parameter_value output_clock_frequency0 "$mhz MHz"
    set_parameter_value output_clock_frequency1 "$mhz MHz"
    set_parameter_value phase_shift1 "[expr {round(1e6 / $mhz) - 3000}] ps"
}
