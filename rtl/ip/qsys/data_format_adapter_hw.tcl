source stream_adapters.tcl
adapter_of_one_property data_format_adapter {
    outSymbolsPerBeat INTEGER 1 outUseEmptyPort STRING AUTO
}

proc elaborate {} {
    check_latency 4 inReadyLatency
    set in [source_side]
    set symbols [value outSymbolsPerBeat]
    sides in $in out \
        [dict replace $in symbols $symbols empty [empty_bits outUseEmptyPort $symbols]]
}
