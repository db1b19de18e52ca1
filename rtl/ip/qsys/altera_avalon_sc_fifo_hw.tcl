source streams.tcl
set_module_property NAME altera_avalon_sc_fifo
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value hdl} {
    SYMBOLS_PER_BEAT 1 true   BITS_PER_SYMBOL 8 true     FIFO_DEPTH 16 true
    CHANNEL_WIDTH 0 true      ERROR_WIDTH 0 true         USE_PACKETS 0 true
    USE_STORE_FORWARD 0 true  EMPTY_LATENCY 3 true       USE_FILL_LEVEL 0 false
    USE_MEMORY_BLOCKS 1 false USE_ALMOST_FULL_IF 0 false USE_ALMOST_EMPTY_IF 0 false
    EXPLICIT_MAXCHANNEL 0 false
} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER $hdl
}
add_parameter ENABLE_EXPLICIT_MAXCHANNEL BOOLEAN false
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_sc_fifo

clock_and_reset clk clk clk_reset reset

proc elaborate {} {
    set depth [value FIFO_DEPTH]
    if {$depth < 2 || (![value USE_MEMORY_BLOCKS] && $depth > 65536)} {
        send_message error "FIFO_DEPTH is $depth, expected at least 2"
    }
    if {[value USE_MEMORY_BLOCKS] && $depth & ($depth - 1)} {
        send_message error "FIFO_DEPTH is $depth, expected a power of two"
    }
    foreach name {USE_ALMOST_FULL_IF USE_ALMOST_EMPTY_IF USE_STORE_FORWARD} {
        if {[value $name] && ![value USE_FILL_LEVEL]} {
            send_message error "$name needs USE_FILL_LEVEL"
        }
    }
    if {[value EMPTY_LATENCY] < 1 || [value EMPTY_LATENCY] > 3} {
        send_message error "EMPTY_LATENCY is [value EMPTY_LATENCY], expected 1 to 3"
    }
    set symbols [value SYMBOLS_PER_BEAT]
    set width [expr {$symbols * [value BITS_PER_SYMBOL]}]
    set packets [value USE_PACKETS]
    set most [expr {[on ENABLE_EXPLICIT_MAXCHANNEL]
                    ? [value EXPLICIT_MAXCHANNEL] : (1 << [value CHANNEL_WIDTH]) - 1}]
    foreach {name end} {in end out start} {
        stream $name $name $end clk clk_reset \
            [list dataBitsPerSymbol [value BITS_PER_SYMBOL] maxChannel $most] \
            [list ready 1 valid 1 data $width startofpacket $packets endofpacket $packets \
                  empty [expr {$packets ? [bits_below $symbols] : 0}] \
                  channel [value CHANNEL_WIDTH] error [value ERROR_WIDTH]]
    }
    if {[value USE_FILL_LEVEL]} {
        add_interface csr avalon end
        set_interface_property csr associatedClock clk
        set_interface_property csr associatedReset clk_reset
        set_interface_property csr readWaitTime 0
        set_interface_property csr readLatency 1
        foreach {role direction bits} "
            address Input [expr {[value USE_STORE_FORWARD] ? 3 : 2}] read Input 1 write Input 1
            writedata Input 32 readdata Output 32
        " { add_interface_port csr csr_$role $role $direction $bits }
    }
    foreach name {almost_full almost_empty} {
        if {![value USE_[string toupper $name]_IF]} { continue }
        stream $name $name start clk clk_reset {} {data 1}
    }
}
