set_module_property NAME altera_reset_bridge
set_module_property ELABORATION_CALLBACK elaborate
add_parameter ACTIVE_LOW_RESET INTEGER 0
add_parameter SYNCHRONOUS_EDGES STRING deassert
add_parameter NUM_RESET_OUTPUTS INTEGER 1
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_reset_bridge

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface in_reset reset end

proc elaborate {} {
    set low [expr {[get_parameter_value ACTIVE_LOW_RESET] ? "_n" : ""}]
    add_interface_port in_reset in_reset$low reset$low Input 1
    for {set n 0} {$n < [get_parameter_value NUM_RESET_OUTPUTS]} {incr n} {
        set name out_reset[expr {$n == 0 ? "" : "_$n"}]
        add_interface $name reset start
        add_interface_port $name $name$low reset$low Output 1
    }
}
