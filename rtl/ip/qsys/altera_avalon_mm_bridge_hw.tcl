set_module_property NAME altera_avalon_mm_bridge
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value} {DATA_WIDTH 32 SYMBOL_WIDTH 8 ADDRESS_WIDTH 10 SYSINFO_ADDR_WIDTH 10 MAX_BURST_SIZE 1
                      MAX_PENDING_RESPONSES 4 PIPELINE_COMMAND 1 PIPELINE_RESPONSE 1
                      USE_AUTO_ADDRESS_WIDTH 0 LINEWRAPBURSTS 0} {
    add_parameter $name INTEGER $value
}
add_parameter ADDRESS_UNITS STRING SYMBOLS
add_parameter HDL_ADDR_WIDTH INTEGER 10
add_parameter BURSTCOUNT_WIDTH INTEGER 1
foreach name {DATA_WIDTH HDL_ADDR_WIDTH BURSTCOUNT_WIDTH PIPELINE_COMMAND PIPELINE_RESPONSE} {
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_mm_bridge

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface s0 avalon end
add_interface m0 avalon start
foreach name {s0 m0} {
    set_interface_property $name associatedClock clk
    set_interface_property $name associatedReset reset
}
set_interface_property s0 bridgesToMaster m0

proc elaborate {} {
    set width [get_parameter_value DATA_WIDTH]
    set address [get_parameter_value ADDRESS_WIDTH]
    if {[string is true [get_parameter_value USE_AUTO_ADDRESS_WIDTH]]} {
        set address [get_parameter_value SYSINFO_ADDR_WIDTH]
    }
    set_parameter_value HDL_ADDR_WIDTH $address
    set counts 1
    while {1 << ($counts - 1) < [get_parameter_value MAX_BURST_SIZE]} { incr counts }
    set_parameter_value BURSTCOUNT_WIDTH $counts
    set_interface_property s0 maximumPendingReadTransactions \
        [get_parameter_value MAX_PENDING_RESPONSES]
    set_interface_property s0 linewrapBursts [get_parameter_value LINEWRAPBURSTS]
    set_interface_property m0 linewrapBursts [get_parameter_value LINEWRAPBURSTS]
    foreach {name into out} {s0 Input Output m0 Output Input} {
        set_interface_property $name addressUnits [get_parameter_value ADDRESS_UNITS]
        add_interface_port $name ${name}_waitrequest waitrequest $out 1
        add_interface_port $name ${name}_readdata readdata $out $width
        add_interface_port $name ${name}_readdatavalid readdatavalid $out 1
        add_interface_port $name ${name}_burstcount burstcount $into $counts
        add_interface_port $name ${name}_writedata writedata $into $width
        add_interface_port $name ${name}_address address $into $address
        add_interface_port $name ${name}_write write $into 1
        add_interface_port $name ${name}_read read $into 1
        add_interface_port $name ${name}_byteenable byteenable $into [expr {$width / 8}]
        add_interface_port $name ${name}_debugaccess debugaccess $into 1
    }
}
