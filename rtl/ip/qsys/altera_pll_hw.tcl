set_module_property NAME altera_pll
set_module_property ELABORATION_CALLBACK elaborate
add_parameter gui_number_of_clocks INTEGER 1
add_parameter gui_use_locked BOOLEAN true
add_parameter gui_reference_clock_frequency FLOAT 100.0
for {set n 0} {$n < 18} {incr n} {
    add_parameter gui_output_clock_frequency$n FLOAT 100.0
    add_parameter gui_phase_shift$n FLOAT 0
    add_parameter gui_phase_shift_deg$n FLOAT 0.0
    add_parameter gui_ps_units$n STRING ps
}
for {set n 0} {$n < 8} {incr n} {
    add_parameter output_clock_frequency$n STRING "0 MHz"
    add_parameter phase_shift$n STRING "0 ps"
    set_parameter_property output_clock_frequency$n HDL_PARAMETER true
    set_parameter_property phase_shift$n HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_pll

add_interface refclk clock end
add_interface_port refclk refclk clk Input 1
add_interface reset reset end
add_interface_port reset rst reset Input 1

proc elaborate {} {
    set count [get_parameter_value gui_number_of_clocks]
    if {$count > 8} { send_message error "$count clocks, expected at most 8" }
    for {set n 0} {$n < $count} {incr n} {
        add_interface outclk$n clock start
        add_interface_port outclk$n outclk_$n clk Output 1
        set mhz [get_parameter_value gui_output_clock_frequency$n]
        set_parameter_value output_clock_frequency$n "$mhz MHz"
        set ps [get_parameter_value gui_phase_shift$n]
        if {[get_parameter_value gui_ps_units$n] eq "degrees"} {
            set ps [expr {[get_parameter_value gui_phase_shift_deg$n] * 1e6 / $mhz / 360}]
        }
        set_parameter_value phase_shift$n "[expr {round($ps)}] ps"
    }
    if {[string is true [get_parameter_value gui_use_locked]]} {
        add_interface locked conduit end
        add_interface_port locked locked export Output 1
    }
}
