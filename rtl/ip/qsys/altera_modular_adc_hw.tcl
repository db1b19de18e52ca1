set_module_property NAME altera_modular_adc
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value} {CORE_VAR 0 ip_is_for_which_adc 1 clkdiv 2 seq_order_length 1} {
    add_parameter $name INTEGER $value
}
for {set n 1} {$n <= 64} {incr n} { add_parameter seq_order_slot_$n INTEGER 30 }
foreach {name value width} {
    CLKDIV 2 0 FIRST 1 0 SEQUENCED 1 0 STORED 1 0 LAST_SLOT 0 6 SLOTS 0 320
} {
    add_parameter $name [expr {$width ? "STD_LOGIC_VECTOR" : "INTEGER"}] $value
    set_parameter_property $name HDL_PARAMETER true
    if {$width} { set_parameter_property $name WIDTH $width }
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_modular_adc

add_interface clock clock end
add_interface_port clock clock_clk clk Input 1
add_interface reset_sink reset end
set_interface_property reset_sink associatedClock clock
add_interface_port reset_sink reset_sink_reset_n reset_n Input 1
add_interface adc_pll_clock clock end
add_interface_port adc_pll_clock adc_pll_clock_clk clk Input 1
add_interface adc_pll_locked conduit end
add_interface_port adc_pll_locked adc_pll_locked_export export Input 1

proc add_slave {name address latency} {
    add_interface $name avalon end
    set_interface_property $name associatedClock clock
    set_interface_property $name associatedReset reset_sink
    set_interface_property $name readLatency $latency
    foreach {role direction bits} {
        read Input 1 write Input 1 writedata Input 32 readdata Output 32
    } { add_interface_port $name ${name}_$role $role $direction $bits }
    add_interface_port $name ${name}_address address Input $address
}

proc add_stream {name kind direction ready} {
    add_interface $name avalon_streaming $kind
    set_interface_property $name associatedClock clock
    set_interface_property $name associatedReset reset_sink
    foreach {role bits} {valid 1 channel 5 startofpacket 1 endofpacket 1} {
        add_interface_port $name ${name}_$role $role $direction $bits
    }
    if {$ready ne ""} { add_interface_port $name ${name}_ready ready $ready 1 }
}

proc elaborate {} {
    set variant [get_parameter_value CORE_VAR]
    if {$variant == 1} {
        send_message error "CORE_VAR is 1, threshold violation detection, which is not simulated"
    }
    set length [get_parameter_value seq_order_length]
    if {$length < 1 || $length > 64} {
        send_message error "seq_order_length is $length, expected 1 to 64"
    }
    set_parameter_value CLKDIV [get_parameter_value clkdiv]
    set_parameter_value FIRST [get_parameter_value ip_is_for_which_adc]
    set_parameter_value SEQUENCED [expr {$variant != 3}]
    set_parameter_value STORED [expr {$variant == 0}]
    set_parameter_value LAST_SLOT [expr {$length - 1}]
    set slots 0
    for {set n 1} {$n <= $length} {incr n} {
        set channel [get_parameter_value seq_order_slot_$n]
        set slots [expr {$slots | ($channel & 31) << (5 * ($n - 1))}]
    }
    set_parameter_value SLOTS $slots
    if {$variant == 3} {
        add_stream command end Input Output
    } else {
        add_slave sequencer_csr 1 1
    }
    if {$variant == 0} {
        add_slave sample_store_csr 7 2
        add_interface sample_store_irq interrupt end
        set_interface_property sample_store_irq associatedAddressablePoint sample_store_csr
        add_interface_port sample_store_irq sample_store_irq_irq irq Output 1
    } else {
        add_stream response start Output ""
        add_interface_port response response_data data Output 12
    }
}
