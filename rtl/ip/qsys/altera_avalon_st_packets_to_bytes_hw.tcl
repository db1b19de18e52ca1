source streams.tcl
set_module_property NAME altera_avalon_st_packets_to_bytes
set_module_property ELABORATION_CALLBACK elaborate
add_parameter CHANNEL_WIDTH INTEGER 8
add_parameter ENCODING INTEGER 0
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_st_packets_to_bytes

clock_and_reset clk clk clk_reset reset_n
foreach {name port end packets} {in_packets_stream in end 1   out_bytes_stream out start 0} {
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
