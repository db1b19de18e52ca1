source streams.tcl
set_module_property NAME altera_avalon_st_splitter
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value} {
    NUMBER_OF_OUTPUTS 2 QUALIFY_VALID_OUT 1 USE_READY 1 USE_VALID 1 USE_PACKETS 0 USE_CHANNEL 0
    USE_ERROR 0 USE_DATA 1 DATA_WIDTH 8 CHANNEL_WIDTH 1 ERROR_WIDTH 1 BITS_PER_SYMBOL 8
    MAX_CHANNELS 1 READY_LATENCY 0
} { add_parameter $name INTEGER $value }
add_parameter ERROR_DESCRIPTOR STRING_LIST ""
hdl_parameters {COUNT 2 DATA 8 EMPTY 1 CHANNEL 1 OWN 1 ERROR 1 QUALIFIED 1 READY 1}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_st_splitter

clock_and_reset clk clk reset reset

proc side {name end} {
    set packets [value USE_PACKETS]
    set channel [value USE_CHANNEL]
    stream $name $name $end clk reset \
        [list dataBitsPerSymbol [value BITS_PER_SYMBOL] readyLatency [value READY_LATENCY] \
              maxChannel [expr {$channel ? [value MAX_CHANNELS] : 0}]] \
        [list valid [value USE_VALID] ready [value USE_READY] \
              data [expr {[value USE_DATA] ? [value DATA_WIDTH] : 0}] \
              startofpacket $packets endofpacket $packets \
              empty [expr {$packets ? [value EMPTY] : 0}] \
              channel [expr {$channel ? [value CHANNEL_WIDTH] : 0}] \
              error [expr {[value USE_ERROR] ? [value ERROR_WIDTH] : 0}]]
}

proc elaborate {} {
    set count [value NUMBER_OF_OUTPUTS]
    if {$count < 1 || $count > 16} {
        send_message error "NUMBER_OF_OUTPUTS is $count, expected 1 to 16"
    }
    set empty [expr {max(1, [bits_below [expr {[value DATA_WIDTH] / [value BITS_PER_SYMBOL]}]])}]
    foreach {name value} [list COUNT $count DATA [value DATA_WIDTH] EMPTY $empty \
        CHANNEL [value CHANNEL_WIDTH] OWN [value CHANNEL_WIDTH] ERROR [value ERROR_WIDTH] \
        QUALIFIED [value QUALIFY_VALID_OUT] READY [value USE_READY]] {
        set_parameter_value $name $value
    }
    side in end
    for {set n 0} {$n < $count} {incr n} { side out$n start }
}
