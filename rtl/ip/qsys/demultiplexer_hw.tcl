set_module_property NAME demultiplexer
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    bitsPerSymbol INTEGER 8   symbolsPerBeat INTEGER 4      inChannelWidth INTEGER 1
    usePackets BOOLEAN false  useHighBitsOfChannel BOOLEAN true
    errorWidth INTEGER 0      numOutputInterfaces INTEGER 2
} { add_parameter $name $type $value }
foreach {name value} {
    COUNT 2 DATA 8 EMPTY 1 CHANNEL 1 OWN 1 ERROR 1 SELECT 1 HIGH 1 DEMULTIPLEXES 1
} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_st_splitter

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset_n reset_n Input 1

proc value {name} { get_parameter_value $name }
proc on {name} { string is true [value $name] }

proc stream {name end channel} {
    set into [expr {$end eq "end" ? "Input" : "Output"}]
    add_interface $name avalon_streaming $end
    foreach {property value} [list associatedClock clk associatedReset reset \
        dataBitsPerSymbol [value bitsPerSymbol] maxChannel [expr {(1 << $channel) - 1}]] {
        set_interface_property $name $property $value
    }
    set packets [on usePackets]
    foreach {role bits} "
        valid 1 data [value DATA] startofpacket $packets endofpacket $packets
        empty [expr {$packets && [value symbolsPerBeat] > 1 ? [value EMPTY] : 0}]
        channel $channel error [value errorWidth]
    " { if {$bits > 0} { add_interface_port $name ${name}_$role $role $into $bits } }
    add_interface_port $name ${name}_ready ready [expr {$end eq "end" ? "Output" : "Input"}] 1
}

proc elaborate {} {
    set count [value numOutputInterfaces]
    if {$count < 1 || $count > 16} {
        send_message error "numOutputInterfaces is $count, expected 1 to 16"
    }
    for {set select 1} {1 << $select < $count} {incr select} {}
    set channel [value inChannelWidth]
    if {$channel < $select} {
        send_message error "inChannelWidth is $channel, expected at least $select for $count outputs"
    }
    for {set empty 1} {1 << $empty < [value symbolsPerBeat]} {incr empty} {}
    set own [expr {$channel - $select}]
    foreach {name value} [list COUNT $count EMPTY $empty CHANNEL $channel SELECT $select \
        DATA [expr {[value symbolsPerBeat] * [value bitsPerSymbol]}] HIGH [on useHighBitsOfChannel] \
        OWN [expr {max($own, 1)}] ERROR [expr {max([value errorWidth], 1)}]] {
        set_parameter_value $name $value
    }
    stream in end $channel
    for {set n 0} {$n < $count} {incr n} { stream out$n start $own }
}
