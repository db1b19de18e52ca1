set_module_property NAME altera_avalon_performance_counter
set_module_property ELABORATION_CALLBACK elaborate
add_parameter numberOfSections INTEGER 3
foreach {name value} {SECTIONS 3 ADDRESS 4} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_performance_counter

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset_n reset_n Input 1
add_interface control_slave avalon end
foreach {property value} {
    associatedClock clk associatedReset reset addressAlignment NATIVE readWaitTime 1
} { set_interface_property control_slave $property $value }
foreach {role direction bits} {
    address Input ADDRESS     begintransfer Input 1     write Input 1
    writedata Input 32        readdata Output 32
} { add_interface_port control_slave $role $role $direction $bits }

proc elaborate {} {
    set sections [get_parameter_value numberOfSections]
    if {$sections < 1 || $sections > 7} {
        send_message error "numberOfSections is $sections, expected 1 to 7"
    }
    set_parameter_value SECTIONS $sections
    set_parameter_value ADDRESS [expr {$sections < 2 ? 3 : $sections < 4 ? 4 : 5}]
    set_module_assignment embeddedsw.CMacro.HOW_MANY_SECTIONS $sections
}
