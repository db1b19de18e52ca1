set_module_property NAME altera_up_avalon_video_stream_router
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    color_bits INTEGER 8   color_planes INTEGER 3   router_type STRING Split   sync BOOLEAN true
    BITS INTEGER 24        SYNC INTEGER 1
} { add_parameter $name $type $value }
set_parameter_property BITS HDL_PARAMETER true
add_fileset synth QUARTUS_SYNTH "" ""

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1

# A stream's ports; they end in _N where there are several.
proc stream {interface side port into against} {
    set bits [expr {[get_parameter_value color_bits] * [get_parameter_value color_planes]}]
    add_interface $interface avalon_streaming $side
    set_interface_property $interface associatedClock clk
    set_interface_property $interface associatedReset reset
    set number [expr {[regexp {_[01]$} $interface last] ? $last : ""}]
    foreach {role direction count} "
        data $into $bits startofpacket $into 1 endofpacket $into 1 valid $into 1
        ready $against 1
    " { add_interface_port $interface ${port}_$role$number $role $direction $count }
}

proc elaborate {} {
    set_parameter_value BITS \
        [expr {[get_parameter_value color_bits] * [get_parameter_value color_planes]}]
    set splits [expr {[get_parameter_value router_type] eq "Split"}]
    set sync [string is true [get_parameter_value sync]]
    if {$splits} {
        set_fileset_property synth TOP_LEVEL de1sim_up_splitter
        stream avalon_stream_router_sink end stream_in Input Output
        stream avalon_stream_router_source_0 start stream_out Output Input
        stream avalon_stream_router_source_1 start stream_out Output Input
    } else {
        set_fileset_property synth TOP_LEVEL de1sim_up_merger
        set_parameter_value SYNC $sync
        set_parameter_property SYNC HDL_PARAMETER true
        stream avalon_stream_router_sink_0 end stream_in Input Output
        stream avalon_stream_router_sink_1 end stream_in Input Output
        stream avalon_stream_router_source start stream_out Output Input
    }
    if {$splits || !$sync} {
        add_interface external_interface conduit end
        add_interface_port external_interface stream_select export Input 1
    }
    if {$sync} {
        set name [expr {$splits ? "avalon_sync_source" : "avalon_sync_sink"}]
        add_interface $name avalon_streaming [expr {$splits ? "start" : "end"}]
        set_interface_property $name associatedClock clk
        set_interface_property $name associatedReset reset
        set into [expr {$splits ? "Output" : "Input"}]
        foreach {role direction} "
            data $into valid $into ready [expr {$splits ? "Input" : "Output"}]
        " { add_interface_port $name sync_$role $role $direction 1 }
    }
}
