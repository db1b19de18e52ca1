source stream_adapters.tcl
adapter altera_avalon_st_adapter in_clk_0 in_rst_0 reset
foreach {name type value} {
    inBitsPerSymbol INTEGER 8      inUsePackets INTEGER 0
    inDataWidth INTEGER 8          outDataWidth INTEGER 32
    inMaxChannel INTEGER 4         outMaxChannel INTEGER 4
    inChannelWidth INTEGER 3       outChannelWidth INTEGER 3
    inErrorWidth INTEGER 2         outErrorWidth INTEGER 2
    inErrorDescriptor STRING_LIST ""
    outErrorDescriptor STRING_LIST ""
    inUseEmptyPort INTEGER 0       outUseEmptyPort INTEGER 0
    inUseValid INTEGER 1           outUseValid INTEGER 1
    inUseReady INTEGER 1           outUseReady INTEGER 1
    inReadyLatency INTEGER 0       outReadyLatency INTEGER 0
} { add_parameter $name $type $value }

proc side_of {which} {
    set width [value ${which}DataWidth]
    set symbol [value inBitsPerSymbol]
    if {$width % $symbol} {
        send_message error "${which}DataWidth is $width, which is no multiple of inBitsPerSymbol, $symbol"
    }
    set symbols [expr {$width / $symbol}]
    return [dict create symbols $symbols empty [empty_bits ${which}UseEmptyPort $symbols] \
                channel [value ${which}ChannelWidth] most [value ${which}MaxChannel] \
                error [value ${which}ErrorWidth] names [value ${which}ErrorDescriptor] \
                valid [on ${which}UseValid] ready [on ${which}UseReady] \
                latency [value ${which}ReadyLatency]]
}

proc elaborate {} {
    check_latency 8 {inReadyLatency outReadyLatency}
    limit_channels
    map_errors [value inErrorDescriptor] [value outErrorDescriptor] [value inErrorWidth]
    sides in_0 [side_of in] out_0 [side_of out]
}
