set_module_property NAME error_adapter
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    inBitsPerSymbol INTEGER 8      inSymbolsPerBeat INTEGER 1
    inChannelWidth INTEGER 0       inMaxChannel INTEGER 0
    inErrorWidth INTEGER 0         inErrorDescriptor STRING_LIST ""
    inUsePackets BOOLEAN false     inUseEmptyPort STRING AUTO
    outErrorWidth INTEGER 0        outErrorDescriptor STRING_LIST ""
    inUseReady BOOLEAN true        inReadyLatency INTEGER 0
} { add_parameter $name $type $value }
foreach {name value} {
    SYMBOL 8 IN_SYMBOLS 1 OUT_SYMBOLS 1 IN_EMPTY 0 OUT_EMPTY 0 IN_CHANNEL 0 OUT_CHANNEL 0
    MAX_CHANNEL -1 IN_ERROR 0 OUT_ERROR 0 NAMED 0 IN_VALID 1 IN_READY 1 IN_LATENCY 0
    OUT_READY 1 OUT_LATENCY 0 RESET_N 1
} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_parameter MAP STD_LOGIC_VECTOR 0
set_parameter_property MAP HDL_PARAMETER true
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_st_adapter

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset_n reset_n Input 1

proc value {name} { get_parameter_value $name }
proc on {name} { string is true [value $name] }

proc names {list} { regexp -all -inline {[^,[:space:]]+} $list }
# Which bits of the source's errors each bit of the sink's has, by their names; the first name is
# that of the highest bit.
proc map_errors {in out width} {
    set in [names $in]
    set out [names $out]
    if {[llength $in] == 0 || [llength $out] == 0} { return }
    set bits ""
    foreach wanted $out {
        set mask ""
        foreach name $in {
            append mask [expr {$name eq $wanted || ($wanted eq "other" && $name ni $out)}]
        }
        append bits [string repeat 0 [expr {max(0, $width - [llength $in])}]] $mask
    }
    set_parameter_value NAMED 1
    set_parameter_value MAP "[string length $bits]'b$bits"
}

# In the order of `stream`, below.
proc elaborate {} {
    foreach name {inReadyLatency} {
        if {[value $name] < 0 || [value $name] > 4} {
            send_message error "$name is [value $name], expected 0 to 4"
        }
    }
    set given [value inErrorDescriptor]
    set wanted [value outErrorDescriptor]
    if {$given ne "" && $wanted eq "" && [value inErrorWidth] != [value outErrorWidth]} {
        send_message error "inErrorDescriptor is given, so outErrorDescriptor is needed: the widths differ"
    }
    map_errors $given $wanted [value inErrorWidth]
    set packets [on inUsePackets]
    set symbols [value inSymbolsPerBeat]
    set empty [empty $packets [value inUseEmptyPort] $symbols]
    stream in in [value inBitsPerSymbol] $symbols $packets $empty \
        [value inChannelWidth] [value inMaxChannel] [value inErrorWidth] [value inErrorDescriptor] \
        1 [on inUseReady] [value inReadyLatency]
    stream out out [value inBitsPerSymbol] $symbols $packets $empty \
        [value inChannelWidth] [value inMaxChannel] [value outErrorWidth] [value outErrorDescriptor] \
        1 [on inUseReady] [value inReadyLatency]
}

# Bits of a stream's empty signal.
proc empty {packets port symbols} {
    for {set bits 0} {1 << $bits < $symbols} {incr bits} {}
    if {!$packets || [string toupper $port] in {NO FALSE 0}} { return 0 }
    return [expr {[string toupper $port] eq "AUTO" ? $bits : $bits < 1 ? 1 : $bits}]
}

proc stream {name side symbol symbols packets empty channel most error names valid ready latency} {
    set end [expr {$side eq "in" ? "end" : "start"}]
    set into [expr {$side eq "in" ? "Input" : "Output"}]
    set against [expr {$side eq "in" ? "Output" : "Input"}]
    set S [string toupper $side]
    add_interface $name avalon_streaming $end
    foreach {property value} [list associatedClock clk associatedReset reset \
        dataBitsPerSymbol $symbol maxChannel $most errorDescriptor $names readyLatency $latency] {
        set_interface_property $name $property $value
    }
    foreach {role bits} "
        valid $valid data [expr {$symbol * $symbols}] startofpacket $packets
        endofpacket $packets empty $empty channel $channel error $error
    " { if {$bits > 0} { add_interface_port $name ${side}_$role $role $into $bits } }
    if {$ready} { add_interface_port $name ${side}_ready ready $against 1 }
    set_parameter_value SYMBOL $symbol
    foreach {parameter value} [list SYMBOLS $symbols EMPTY $empty CHANNEL $channel ERROR $error \
                                    READY $ready LATENCY $latency] {
        set_parameter_value ${S}_$parameter $value
    }
    if {$side eq "in"} { set_parameter_value IN_VALID $valid }
}
