set_module_property NAME altera_up_avalon_adc_mega
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    board STRING DE1-SoC   numch_ INTEGER 8   sclk_freq FLOAT 12.5   sys_clk_freq FLOAT 50
} { add_parameter $name $type $value }
foreach {name value} {MAX10 0 CHANNELS 8 HALF 4 CONVERSION 200 MHZ 50 PERIOD_PS 20000} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_up_avalon_adc_mega

add_interface clk clock end
add_interface_port clk CLOCK clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset RESET reset Input 1
add_interface external_interface conduit end
foreach {name role direction} {
    ADC_SCLK sclk Output ADC_CS_N cs_n Output ADC_DOUT dout Input ADC_DIN din Output
} { add_interface_port external_interface $name $role $direction 1 }
add_interface readings conduit end
for {set n 0} {$n < 8} {incr n} { add_interface_port readings CH$n CH$n Output 12 }

proc elaborate {} {
    set is_lite [expr {[get_parameter_value board] eq "DE10-Lite"}]
    set most [expr {$is_lite ? 6 : 8}]
    set channels [get_parameter_value numch_]
    if {$channels < 1 || $channels > $most} {
        send_message error "numch_ is $channels, expected 1 to $most"
    }
    set mhz [get_parameter_value sys_clk_freq]
    if {$mhz <= 0 || round($mhz) != $mhz} {
        send_message error "sys_clk_freq is $mhz, expected whole MHz"
    }
    set_parameter_value MAX10 $is_lite
    set_parameter_value CHANNELS $channels
    set_parameter_value MHZ [expr {int($mhz)}]
    set_parameter_value PERIOD_PS [expr {int(round(1e6 / $mhz))}]
    set sclk [get_parameter_value sclk_freq]
    set_parameter_value HALF [expr {max(1, int(ceil($mhz / (2 * $sclk))))}]
    set_parameter_value CONVERSION [expr {max(1, int(ceil($mhz * 2)))}]
}
