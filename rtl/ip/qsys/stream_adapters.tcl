# stream_adapters.tcl - what the descriptions of Platform Designer's stream adapters share
#
# Each is a de1sim_st_adapter.  A side of it is a dictionary: symbols of a beat, valid and ready,
# bits of empty, channel and error, the most channels, the names of the errors, the ready latency.

source streams.tcl

proc adapter {kind the_clock the_reset reset_port} {
    global clock reset
    set clock $the_clock
    set reset $the_reset
    set_module_property NAME $kind
    set_module_property ELABORATION_CALLBACK elaborate
    hdl_parameters "
        SYMBOL 8 IN_SYMBOLS 1 OUT_SYMBOLS 1 IN_EMPTY 0 OUT_EMPTY 0 IN_CHANNEL 0 OUT_CHANNEL 0
        MAX_CHANNEL -1 IN_ERROR 0 OUT_ERROR 0 NAMED 0 IN_VALID 1 IN_READY 1 IN_LATENCY 0
        OUT_READY 1 OUT_LATENCY 0 RESET_N [string match *_n $reset_port]
    "
    add_parameter MAP STD_LOGIC_VECTOR 0
    set_parameter_property MAP HDL_PARAMETER true
    add_fileset synth QUARTUS_SYNTH "" ""
    set_fileset_property synth TOP_LEVEL de1sim_st_adapter
    clock_and_reset $clock clk $reset $reset_port
}

# An adapter of one property: the parameters of its source, and those of the sink that differ.
proc adapter_of_one_property {kind parameters} {
    adapter $kind clk reset reset_n
    foreach {name type value} [concat {
        inBitsPerSymbol INTEGER 8      inSymbolsPerBeat INTEGER 1
        inChannelWidth INTEGER 0       inMaxChannel INTEGER 0
        inErrorWidth INTEGER 0         inErrorDescriptor STRING_LIST ""
        inUsePackets BOOLEAN false     inUseEmptyPort STRING AUTO
        inUseReady BOOLEAN true        inReadyLatency INTEGER 0
    } $parameters] { add_parameter $name $type $value }
}

proc source_side {} {
    set symbols [value inSymbolsPerBeat]
    return [dict create symbols $symbols empty [empty_bits inUseEmptyPort $symbols] \
                channel [value inChannelWidth] most [value inMaxChannel] \
                error [value inErrorWidth] names [value inErrorDescriptor] \
                valid 1 ready [on inUseReady] latency [value inReadyLatency]]
}

proc empty_bits {parameter symbols} {
    set port [string toupper [value $parameter]]
    set bits [bits_below $symbols]
    if {![on inUsePackets] || $port in {NO FALSE 0}} { return 0 }
    return [expr {$port eq "AUTO" ? $bits : $bits < 1 ? 1 : $bits}]
}

proc check_latency {most names} {
    foreach name $names {
        if {[value $name] < 0 || [value $name] > $most} {
            send_message error "$name is [value $name], expected 0 to $most"
        }
    }
}

# What the sink has no channel for does not pass.
proc limit_channels {} {
    set_parameter_value MAX_CHANNEL [expr {[value inChannelWidth] == 0 ? -1
                                           : [value outChannelWidth] == 0 ? 0
                                           : [value outMaxChannel]}]
}

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

proc sides {in_name in out_name out} {
    side $in_name in end $in
    side $out_name out start $out
    set_parameter_value SYMBOL [value inBitsPerSymbol]
    set_parameter_value IN_VALID [dict get $in valid]
}

proc side {name prefix end signals} {
    global clock reset
    dict with signals {}
    set packets [on inUsePackets]
    set symbol [value inBitsPerSymbol]
    stream $name $prefix $end $clock $reset \
        [list dataBitsPerSymbol $symbol maxChannel $most errorDescriptor $names \
              readyLatency $latency] \
        [list valid $valid ready $ready data [expr {$symbol * $symbols}] startofpacket $packets \
              endofpacket $packets empty $empty channel $channel error $error]
    foreach {parameter value} [list SYMBOLS $symbols EMPTY $empty CHANNEL $channel ERROR $error \
                                    READY $ready LATENCY $latency] {
        set_parameter_value [string toupper $prefix]_$parameter $value
    }
}
