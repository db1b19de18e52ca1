source streams.tcl
set_module_property NAME altera_avalon_st_bytes_to_packets
set_module_property ELABORATION_CALLBACK elaborate
add_parameter CHANNEL_WIDTH INTEGER 8
add_parameter ENCODING INTEGER 0
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_st_bytes_to_packets

clock_and_reset clk clk clk_reset reset_n
foreach {name port end packets} {in_bytes_stream in end 0   out_packets_stream out start 1} {
    stream $name $port $end clk clk_reset \
        [list dataBitsPerSymbol 8 maxChannel [expr {$packets ? 255 : 0}]] \
        [list ready 1 valid 1 data 8 channel [expr {$packets ? 8 : 0}] startofpacket $packets \
              endofpacket $packets]
}

proc elaborate {} {
    if {[get_parameter_value ENCODING] != 0} {
        send_message error "ENCODING is [get_parameter_value ENCODING]: channels of a variable length\
            cannot be simulated"
    }
}
