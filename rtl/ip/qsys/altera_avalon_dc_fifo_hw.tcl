set_module_property NAME altera_avalon_dc_fifo
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value hdl} {
    SYMBOLS_PER_BEAT 1 true    BITS_PER_SYMBOL 8 true        FIFO_DEPTH 16 true
    CHANNEL_WIDTH 0 true       ERROR_WIDTH 0 true            USE_PACKETS 0 false
    STREAM_ALMOST_FULL 0 true  STREAM_ALMOST_EMPTY 0 true    USE_IN_FILL_LEVEL 0 false
    USE_OUT_FILL_LEVEL 0 false USE_SPACE_AVAIL_IF 0 false    WR_SYNC_DEPTH 3 false
    RD_SYNC_DEPTH 3 false      EXPLICIT_MAXCHANNEL 0 false
} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER $hdl
}
add_parameter ENABLE_EXPLICIT_MAXCHANNEL BOOLEAN false
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_dc_fifo

foreach side {in out} {
    add_interface ${side}_clk clock end
    add_interface_port ${side}_clk ${side}_clk clk Input 1
    add_interface ${side}_clk_reset reset end
    set_interface_property ${side}_clk_reset associatedClock ${side}_clk
    add_interface_port ${side}_clk_reset ${side}_reset_n reset_n Input 1
}

proc value {name} { get_parameter_value $name }

proc interface {name type end side} {
    add_interface $name $type $end
    set_interface_property $name associatedClock ${side}_clk
    set_interface_property $name associatedReset ${side}_clk_reset
}

proc elaborate {} {
    set depth [value FIFO_DEPTH]
    if {$depth < 2 || $depth & ($depth - 1)} {
        send_message error "FIFO_DEPTH is $depth, expected a power of two from 2 on"
    }
    set symbols [value SYMBOLS_PER_BEAT]
    set width [expr {$symbols * [value BITS_PER_SYMBOL]}]
    for {set empty 0} {1 << $empty < $symbols} {incr empty} {}
    for {set log2 0} {1 << $log2 < $depth} {incr log2} {}
    set packets [value USE_PACKETS]
    set most [expr {[string is true [value ENABLE_EXPLICIT_MAXCHANNEL]]
                    ? [value EXPLICIT_MAXCHANNEL] : (1 << [value CHANNEL_WIDTH]) - 1}]
    foreach {name end into against fill latency wait} {
        in end Input Output USE_IN_FILL_LEVEL 1 0   out start Output Input USE_OUT_FILL_LEVEL 0 1
    } {
        interface $name avalon_streaming $end $name
        set_interface_property $name dataBitsPerSymbol [value BITS_PER_SYMBOL]
        set_interface_property $name maxChannel $most
        add_interface_port $name ${name}_ready ready $against 1
        foreach {role bits} "
            valid 1  data $width  startofpacket $packets  endofpacket $packets
            empty [expr {$packets ? $empty : 0}]  channel [value CHANNEL_WIDTH]
            error [value ERROR_WIDTH]
        " { if {$bits > 0} { add_interface_port $name ${name}_$role $role $into $bits } }
        if {![value $fill]} { continue }
        interface ${name}_csr avalon end $name
        set_interface_property ${name}_csr readWaitTime $wait
        set_interface_property ${name}_csr readLatency $latency
        foreach {role direction bits} {
            address Input 1 read Input 1 write Input 1 writedata Input 32 readdata Output 32
        } { add_interface_port ${name}_csr ${name}_csr_$role $role $direction $bits }
    }
    foreach {name side} {almost_full in almost_empty out} {
        if {![value STREAM_[string toupper $name]]} { continue }
        interface $name avalon_streaming start $side
        add_interface_port $name ${name}_valid valid Output 1
        add_interface_port $name ${name}_data data Output 1
    }
    if {[value USE_SPACE_AVAIL_IF]} {
        interface space_avail avalon_streaming start in
        add_interface_port space_avail space_avail_data data Output [expr {$log2 + 1}]
    }
}
