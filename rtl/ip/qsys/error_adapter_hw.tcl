source stream_adapters.tcl
adapter_of_one_property error_adapter {
    outErrorWidth INTEGER 0 outErrorDescriptor STRING_LIST ""
}

proc elaborate {} {
    check_latency 4 inReadyLatency
    set in [source_side]
    set names [value outErrorDescriptor]
    set width [value outErrorWidth]
    if {[dict get $in names] ne "" && $names eq "" && [dict get $in error] != $width} {
        send_message error "inErrorDescriptor is given, so outErrorDescriptor is needed: the widths differ"
    }
    map_errors [dict get $in names] $names [dict get $in error]
    sides in $in out [dict replace $in error $width names $names]
}
