set_module_property NAME altera_address_span_extender
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value} {
    DATA_WIDTH 32 MASTER_ADDRESS_WIDTH 32 SLAVE_ADDRESS_WIDTH 16 BURSTCOUNT_WIDTH 1
    CNTL_ADDRESS_WIDTH 1 SUB_WINDOW_COUNT 1 MAX_PENDING_READS 1
} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER [expr {$name ne "MAX_PENDING_READS"}]
}
add_parameter MASTER_ADDRESS_DEF LONG 0
set_parameter_property MASTER_ADDRESS_DEF HDL_PARAMETER true
set_parameter_property MASTER_ADDRESS_DEF WIDTH 64
add_parameter ENABLE_SLAVE_PORT BOOLEAN true
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_address_span_extender

add_interface clock clock end
add_interface_port clock clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clock
add_interface_port reset reset reset Input 1
add_interface windowed_slave avalon end
add_interface expanded_master avalon start
add_interface cntl avalon end
foreach name {windowed_slave expanded_master cntl} {
    set_interface_property $name associatedClock clock
    set_interface_property $name associatedReset reset
}
set_interface_property cntl readLatency 1
set_interface_property cntl readWaitTime 0

proc elaborate {} {
    set windows [get_parameter_value SUB_WINDOW_COUNT]
    set choice 0
    while {1 << $choice < $windows} { incr choice }
    if {$windows < 1 || 1 << $choice != $windows} {
        send_message error "SUB_WINDOW_COUNT is $windows, expected a power of 2"
    }
    set_parameter_value CNTL_ADDRESS_WIDTH [expr {max(1, $choice)}]
    set bits [get_parameter_value DATA_WIDTH]
    set_interface_property windowed_slave maximumPendingReadTransactions \
        [get_parameter_value MAX_PENDING_READS]
    foreach {interface port address into against} "
        windowed_slave avs_s0 [get_parameter_value SLAVE_ADDRESS_WIDTH] Input Output
        expanded_master avm_m0 [get_parameter_value MASTER_ADDRESS_WIDTH] Output Input
    " {
        foreach {role direction count} "
            address $into $address                read $into 1
            write $into 1                         writedata $into $bits
            byteenable $into [expr {$bits / 8}]   burstcount $into [get_parameter_value BURSTCOUNT_WIDTH]
            readdata $against $bits               readdatavalid $against 1
            waitrequest $against 1
        " { add_interface_port $interface ${port}_$role $role $direction $count }
    }
    if {[string is true [get_parameter_value ENABLE_SLAVE_PORT]]} {
        foreach {role direction count} "
            address Input [get_parameter_value CNTL_ADDRESS_WIDTH]
            read Input 1 write Input 1 writedata Input 64 byteenable Input 8 readdata Output 64
        " { add_interface_port cntl avs_cntl_$role $role $direction $count }
    }
}
