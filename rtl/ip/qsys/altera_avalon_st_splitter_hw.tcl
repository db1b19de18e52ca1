set_module_property NAME altera_avalon_st_splitter
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value} {
    NUMBER_OF_OUTPUTS 2 QUALIFY_VALID_OUT 1 USE_READY 1 USE_VALID 1 USE_PACKETS 0 USE_CHANNEL 0
    USE_ERROR 0 USE_DATA 1 DATA_WIDTH 8 CHANNEL_WIDTH 1 ERROR_WIDTH 1 BITS_PER_SYMBOL 8
    MAX_CHANNELS 1 READY_LATENCY 0
} { add_parameter $name INTEGER $value }
add_parameter ERROR_DESCRIPTOR STRING_LIST ""
foreach {name value} {COUNT 2 DATA 8 EMPTY 1 CHANNEL 1 OWN 1 ERROR 1 QUALIFIED 1 READY 1} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_st_splitter

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1

proc value {name} { get_parameter_value $name }

proc stream {name port end} {
    set into [expr {$end eq "end" ? "Input" : "Output"}]
    add_interface $name avalon_streaming $end
    foreach {property value} [list associatedClock clk associatedReset reset \
        dataBitsPerSymbol [value BITS_PER_SYMBOL] readyLatency [value READY_LATENCY] \
        maxChannel [expr {[value USE_CHANNEL] ? [value MAX_CHANNELS] : 0}]] {
        set_interface_property $name $property $value
    }
    set packets [value USE_PACKETS]
    foreach {role bits} "
        valid [value USE_VALID] data [expr {[value USE_DATA] ? [value DATA_WIDTH] : 0}]
        startofpacket $packets endofpacket $packets empty [expr {$packets ? [value EMPTY] : 0}]
        channel [expr {[value USE_CHANNEL] ? [value CHANNEL_WIDTH] : 0}]
        error [expr {[value USE_ERROR] ? [value ERROR_WIDTH] : 0}]
    " { if {$bits > 0} { add_interface_port $name ${port}_$role $role $into $bits } }
    if {[value USE_READY]} {
        add_interface_port $name ${port}_ready ready [expr {$end eq "end" ? "Output" : "Input"}] 1
    }
}

proc elaborate {} {
    set count [value NUMBER_OF_OUTPUTS]
    if {$count < 1 || $count > 16} {
        send_message error "NUMBER_OF_OUTPUTS is $count, expected 1 to 16"
    }
    for {set empty 1} {1 << $empty < [value DATA_WIDTH] / [value BITS_PER_SYMBOL]} {incr empty} {}
    foreach {name value} [list COUNT $count DATA [value DATA_WIDTH] EMPTY $empty \
        CHANNEL [value CHANNEL_WIDTH] OWN [value CHANNEL_WIDTH] ERROR [value ERROR_WIDTH] \
        QUALIFIED [value QUALIFY_VALID_OUT] READY [value USE_READY]] {
        set_parameter_value $name $value
    }
    stream in in end
    for {set n 0} {$n < $count} {incr n} { stream out$n out$n start }
}
