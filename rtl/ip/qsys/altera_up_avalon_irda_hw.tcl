set_module_property NAME altera_up_avalon_irda
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    avalon_bus_type STRING {Memory Mapped}   baud LONG 115200       parity STRING None
    data_bits INTEGER 8                      stop_bits INTEGER 1    AUTO_CLK_CLOCK_RATE LONG 50000000
} { add_parameter $name $type $value }
foreach {name value} {BIT 434 SAMPLE 217 PULSE 0 DATA 8 PARITY 0 STOP 1} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_up_serial

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_irda_slave avalon end
set_interface_property avalon_irda_slave associatedClock clk
set_interface_property avalon_irda_slave associatedReset reset
set_interface_property avalon_irda_slave readLatency 1
set_interface_property avalon_irda_slave readWaitTime 0
foreach {name direction bits} {
    address Input 1 chipselect Input 1 byteenable Input 4 read Input 1 write Input 1
    writedata Input 32 readdata Output 32
} { add_interface_port avalon_irda_slave $name $name $direction $bits }
add_interface interrupt interrupt end
set_interface_property interrupt associatedAddressablePoint avalon_irda_slave
add_interface_port interrupt irq irq Output 1
add_interface external_interface conduit end
add_interface_port external_interface rxd RXD Input 1
add_interface_port external_interface txd TXD Output 1

proc elaborate {} {
    if {[get_parameter_value avalon_bus_type] ne "Memory Mapped"} {
        send_message error "avalon_bus_type is \"[get_parameter_value avalon_bus_type]\", of which\
            only Memory Mapped can be simulated"
    }
    set rate [get_parameter_value AUTO_CLK_CLOCK_RATE]
    if {$rate <= 0} { set rate 50000000 }
    set baud [get_parameter_value baud]
    set bit [expr {$baud > 0 ? $rate / $baud : 0}]
    if {$bit < 16 || $bit > 1000000} {
        send_message error "baud is $baud, expected 1/16 of the clock's $rate Hz at most"
    }
    set parity [lsearch {None Odd Even} [get_parameter_value parity]]
    if {$parity < 0} {
        send_message error "parity is \"[get_parameter_value parity]\", expected None, Odd or Even"
    }
    # Light: a pulse of 3/16 of a bit, of which 9/64 of a bit after its begin is within.
    foreach {name value} "BIT $bit SAMPLE [expr {9 * $bit / 64}] PULSE [expr {3 * $bit / 16}] \
        PARITY $parity DATA [get_parameter_value data_bits] STOP [get_parameter_value stop_bits]" {
        set_parameter_value $name $value
    }
}
