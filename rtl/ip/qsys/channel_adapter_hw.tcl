source stream_adapters.tcl
adapter_of_one_property channel_adapter {outChannelWidth INTEGER 0 outMaxChannel INTEGER 0}

proc elaborate {} {
    check_latency 4 inReadyLatency
    limit_channels
    set in [source_side]
    sides in $in out \
        [dict replace $in channel [value outChannelWidth] most [value outMaxChannel]]
}
