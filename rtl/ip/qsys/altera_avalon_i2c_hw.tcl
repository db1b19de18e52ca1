set_module_property NAME altera_avalon_i2c
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value} {USE_AV_ST 0 FIFO_DEPTH 4 FIFO_DEPTH_LOG2 2} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_parameter clockRate INTEGER 0
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_i2c
set_module_assignment embeddedsw.dts.vendor altr
set_module_assignment embeddedsw.dts.name i2c
set_module_assignment embeddedsw.dts.group i2c
set_module_assignment embeddedsw.dts.compatible {altr,softip-i2c-v1.0}

add_interface clock clock end
add_interface_port clock clk clk Input 1
add_interface reset_sink reset end
set_interface_property reset_sink associatedClock clock
add_interface_port reset_sink rst_n reset_n Input 1
add_interface interrupt_sender interrupt end
set_interface_property interrupt_sender associatedAddressablePoint csr
add_interface_port interrupt_sender intr irq Output 1
add_interface csr avalon end
foreach {property value} {
    associatedClock clock associatedReset reset_sink readLatency 2 readWaitTime 0
} { set_interface_property csr $property $value }
foreach {port role direction bits} {
    addr address Input 4            read read Input 1            write write Input 1
    writedata writedata Input 32    readdata readdata Output 32
} { add_interface_port csr $port $role $direction $bits }
add_interface i2c_serial conduit end
foreach {role direction} {sda_in Input scl_in Input sda_oe Output scl_oe Output} {
    add_interface_port i2c_serial $role $role $direction 1
}

proc elaborate {} {
    set depth [get_parameter_value FIFO_DEPTH]
    if {$depth ni {4 8 16 32 64 128 256}} {
        send_message error "FIFO_DEPTH is $depth, expected 4, 8, 16, 32, 64, 128 or 256"
    }
    set_parameter_value FIFO_DEPTH_LOG2 [expr {int(round(log($depth) / log(2)))}]
    foreach {macro name} {FIFO_DEPTH FIFO_DEPTH FREQ clockRate USE_AV_ST USE_AV_ST} {
        set_module_assignment embeddedsw.CMacro.$macro [get_parameter_value $name]
    }
    if {[get_parameter_value USE_AV_ST]} {
        foreach {interface end prefix bits in out} {
            rx_data_source start src 8 Output Input transfer_command_sink end snk 16 Input Output
        } {
            add_interface $interface avalon_streaming $end
            set_interface_property $interface associatedClock clock
            set_interface_property $interface associatedReset reset_sink
            add_interface_port $interface ${prefix}_data data $in $bits
            add_interface_port $interface ${prefix}_valid valid $in 1
            add_interface_port $interface ${prefix}_ready ready $out 1
        }
    }
}
