set_module_property NAME altera_clock_bridge
set_module_property ELABORATION_CALLBACK elaborate
add_parameter NUM_CLOCK_OUTPUTS INTEGER 1
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_clock_bridge

add_interface in_clk clock end
add_interface_port in_clk in_clk clk Input 1

proc elaborate {} {
    for {set n 0} {$n < [get_parameter_value NUM_CLOCK_OUTPUTS]} {incr n} {
        set name out_clk[expr {$n == 0 ? "" : "_$n"}]
        add_interface $name clock start
        set_interface_property $name associatedDirectClock in_clk
        add_interface_port $name $name clk Output 1
    }
}
