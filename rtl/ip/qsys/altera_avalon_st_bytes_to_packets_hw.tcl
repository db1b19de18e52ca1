set_module_property NAME altera_avalon_st_bytes_to_packets
set_module_property ELABORATION_CALLBACK elaborate
add_parameter CHANNEL_WIDTH INTEGER 8
add_parameter ENCODING INTEGER 0
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_st_bytes_to_packets

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface clk_reset reset end
set_interface_property clk_reset associatedClock clk
add_interface_port clk_reset reset_n reset_n Input 1
foreach {name end port into against packets} {
    in_bytes_stream end in Input Output 0
    out_packets_stream start out Output Input 1
} {
    add_interface $name avalon_streaming $end
    foreach {property value} "
        associatedClock clk associatedReset clk_reset dataBitsPerSymbol 8
        maxChannel [expr {$packets ? 255 : 0}]
    " { set_interface_property $name $property $value }
    add_interface_port $name ${port}_ready ready $against 1
    add_interface_port $name ${port}_valid valid $into 1
    add_interface_port $name ${port}_data data $into 8
    if {!$packets} { continue }
    add_interface_port $name ${port}_channel channel $into 8
    add_interface_port $name ${port}_startofpacket startofpacket $into 1
    add_interface_port $name ${port}_endofpacket endofpacket $into 1
}

proc elaborate {} {
    if {[get_parameter_value ENCODING] != 0} {
        send_message error "ENCODING is [get_parameter_value ENCODING]: channels of a variable length\
            cannot be simulated"
    }
}
