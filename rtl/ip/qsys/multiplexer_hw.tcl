source streams.tcl
set_module_property NAME multiplexer
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    bitsPerSymbol INTEGER 8   symbolsPerBeat INTEGER 4      outChannelWidth INTEGER 1
    usePackets BOOLEAN false  useHighBitsOfChannel BOOLEAN true
    errorWidth INTEGER 0      numInputInterfaces INTEGER 2
    schedulingSize INTEGER 2  packetScheduling BOOLEAN false
} { add_parameter $name $type $value }
hdl_parameters {
    COUNT 2 DATA 8 EMPTY 1 CHANNEL 1 OWN 1 ERROR 1 SELECT 1 HIGH 1 SIZE 2 BY_PACKETS 0
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_st_multiplexer

clock_and_reset clk clk reset reset_n

proc side {name end channel} {
    set packets [on usePackets]
    set empty [expr {$packets && [value symbolsPerBeat] > 1 ? [value EMPTY] : 0}]
    stream $name $name $end clk reset \
        [list dataBitsPerSymbol [value bitsPerSymbol] maxChannel [expr {(1 << $channel) - 1}]] \
        [list valid 1 ready 1 data [value DATA] startofpacket $packets endofpacket $packets \
              empty $empty channel $channel error [value errorWidth]]
}

proc elaborate {} {
    set count [value numInputInterfaces]
    if {$count < 2 || $count > 16} {
        send_message error "numInputInterfaces is $count, expected 2 to 16"
    }
    set select [expr {max(1, [bits_below $count])}]
    set channel [value outChannelWidth]
    if {$channel < $select} {
        send_message error "outChannelWidth is $channel, expected at least $select for $count inputs"
    }
    if {[on packetScheduling] && ![on usePackets]} {
        send_message error "packetScheduling needs usePackets"
    }
    set empty [expr {max(1, [bits_below [value symbolsPerBeat]])}]
    set own [expr {$channel - $select}]
    foreach {name value} [list COUNT $count EMPTY $empty CHANNEL $channel SELECT $select \
        DATA [expr {[value symbolsPerBeat] * [value bitsPerSymbol]}] HIGH [on useHighBitsOfChannel] \
        OWN [expr {max($own, 1)}] ERROR [expr {max([value errorWidth], 1)}] \
        SIZE [value schedulingSize] BY_PACKETS [on packetScheduling]] {
        set_parameter_value $name $value
    }
    side out start $channel
    for {set n 0} {$n < $count} {incr n} { side in$n end $own }
}
