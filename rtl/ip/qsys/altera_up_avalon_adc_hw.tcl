set_module_property NAME altera_up_avalon_adc
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    board STRING DE1-SoC   board_rev STRING Autodetect   numch_ INTEGER 8   sclk_freq FLOAT 12.5
    AUTO_CLK_CLOCK_RATE LONG 50000000
} { add_parameter $name $type $value }
foreach {name value} {CHANNELS 8 HALF 4 CONVERSION 200 MHZ 50 PERIOD_PS 20000} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_up_avalon_adc

add_interface clk clock end
add_interface_port clk clock clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface adc_slave avalon end
set_interface_property adc_slave associatedClock clk
set_interface_property adc_slave associatedReset reset
foreach {name direction bits} {
    address Input 3 read Input 1 write Input 1 writedata Input 32 readdata Output 32
    waitrequest Output 1
} { add_interface_port adc_slave $name $name $direction $bits }
add_interface external_interface conduit end
foreach {name direction} {sclk Output cs_n Output dout Input din Output} {
    add_interface_port external_interface adc_$name $name $direction 1
}

proc elaborate {} {
    set is_lite [expr {[get_parameter_value board] eq "DE10-Lite"}]
    set most [expr {$is_lite ? 6 : 8}]
    set channels [get_parameter_value numch_]
    if {$channels < 1 || $channels > $most} {
        send_message error "numch_ is $channels, expected 1 to $most"
    }
    set_parameter_value CHANNELS $channels
    set rate [get_parameter_value AUTO_CLK_CLOCK_RATE]
    foreach name [expr {$is_lite ? {HALF CONVERSION} : {MHZ PERIOD_PS}}] {
        set_parameter_property $name HDL_PARAMETER false
    }
    if {$is_lite} { set_fileset_property synth TOP_LEVEL altera_up_avalon_adc_max10 }
    if {$rate <= 0} { return }
    set_parameter_value MHZ [expr {int(round($rate / 1e6))}]
    set_parameter_value PERIOD_PS [expr {int(round(1e12 / $rate))}]
    if {$is_lite} { return }
    set mhz [get_parameter_value sclk_freq]
    if {$mhz <= 0 || $mhz > 40} {
        send_message error "sclk_freq is $mhz, expected MHz up to the LTC2308's 40"
    }
    set_parameter_value HALF [expr {max(1, int(ceil($rate / ($mhz * 2e6))))}]
    set_parameter_value CONVERSION [expr {max(1, int(ceil($rate * 2e-6)))}]
}
