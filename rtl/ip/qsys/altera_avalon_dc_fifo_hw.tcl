source streams.tcl
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
    clock_and_reset ${side}_clk ${side}_clk ${side}_clk_reset ${side}_reset_n
}

proc elaborate {} {
    set depth [value FIFO_DEPTH]
    if {$depth < 2 || $depth & ($depth - 1)} {
        send_message error "FIFO_DEPTH is $depth, expected a power of two from 2 on"
    }
    set symbols [value SYMBOLS_PER_BEAT]
    set width [expr {$symbols * [value BITS_PER_SYMBOL]}]
    set packets [value USE_PACKETS]
    set most [expr {[on ENABLE_EXPLICIT_MAXCHANNEL]
                    ? [value EXPLICIT_MAXCHANNEL] : (1 << [value CHANNEL_WIDTH]) - 1}]
    foreach {name end fill latency wait} {
        in end USE_IN_FILL_LEVEL 1 0   out start USE_OUT_FILL_LEVEL 0 1
    } {
        stream $name $name $end ${name}_clk ${name}_clk_reset \
            [list dataBitsPerSymbol [value BITS_PER_SYMBOL] maxChannel $most] \
            [list ready 1 valid 1 data $width startofpacket $packets endofpacket $packets \
                  empty [expr {$packets ? [bits_below $symbols] : 0}] \
                  channel [value CHANNEL_WIDTH] error [value ERROR_WIDTH]]
        if {![value $fill]} { continue }
        add_interface ${name}_csr avalon end
        set_interface_property ${name}_csr associatedClock ${name}_clk
        set_interface_property ${name}_csr associatedReset ${name}_clk_reset
        set_interface_property ${name}_csr readWaitTime $wait
        set_interface_property ${name}_csr readLatency $latency
        foreach {role direction bits} {
            address Input 1 read Input 1 write Input 1 writedata Input 32 readdata Output 32
        } { add_interface_port ${name}_csr ${name}_csr_$role $role $direction $bits }
    }
    foreach {name side} {almost_full in almost_empty out} {
        if {![value STREAM_[string toupper $name]]} { continue }
        stream $name $name start ${side}_clk ${side}_clk_reset {} {valid 1 data 1}
    }
    if {[value USE_SPACE_AVAIL_IF]} {
        stream space_avail space_avail start in_clk in_clk_reset {} \
            [list data [expr {[bits_below $depth] + 1}]]
    }
}
