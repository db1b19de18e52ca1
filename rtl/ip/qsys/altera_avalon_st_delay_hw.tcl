source streams.tcl
set_module_property NAME altera_avalon_st_delay
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value hdl} {
    NUMBER_OF_DELAY_CLOCKS 1 true  DATA_WIDTH 8 true     EMPTY_WIDTH 1 true   CHANNEL_WIDTH 1 true
    ERROR_WIDTH 1 true             BITS_PER_SYMBOL 8 false USE_PACKETS 0 false USE_CHANNEL 0 false
    USE_ERROR 0 false              MAX_CHANNELS 1 false
} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER $hdl
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_st_delay

clock_and_reset clk clk clk_reset reset

proc elaborate {} {
    set clocks [value NUMBER_OF_DELAY_CLOCKS]
    if {$clocks < 0 || $clocks > 16} {
        send_message error "NUMBER_OF_DELAY_CLOCKS is $clocks, expected 0 to 16"
    }
    set empty [expr {max(1, [bits_below [expr {[value DATA_WIDTH] / [value BITS_PER_SYMBOL]}]])}]
    set_parameter_value EMPTY_WIDTH $empty
    foreach name {CHANNEL_WIDTH ERROR_WIDTH} {
        if {[value $name] < 1} { set_parameter_value $name 1 }
    }
    set packets [value USE_PACKETS]
    foreach {name end} {in end out start} {
        stream $name ${name}0 $end clk clk_reset \
            [list dataBitsPerSymbol [value BITS_PER_SYMBOL] \
                  maxChannel [expr {[value USE_CHANNEL] ? [value MAX_CHANNELS] : 0}]] \
            [list valid 1 data [value DATA_WIDTH] startofpacket $packets endofpacket $packets \
                  empty [expr {$packets ? $empty : 0}] \
                  channel [expr {[value USE_CHANNEL] ? [value CHANNEL_WIDTH] : 0}] \
                  error [expr {[value USE_ERROR] ? [value ERROR_WIDTH] : 0}]]
    }
}
