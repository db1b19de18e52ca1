source stream_adapters.tcl
adapter_of_one_property timing_adapter {
    inUseValid BOOLEAN true   outUseValid BOOLEAN true
    outUseReady BOOLEAN true  outReadyLatency INTEGER 0
}

proc elaborate {} {
    check_latency 4 {inReadyLatency outReadyLatency}
    set in [dict replace [source_side] valid [on inUseValid]]
    sides in $in out [dict replace $in valid [on outUseValid] ready [on outUseReady] \
                          latency [value outReadyLatency]]
}
