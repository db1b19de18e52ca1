set_module_property NAME altera_up_avalon_ps2
set_module_property ELABORATION_CALLBACK elaborate
add_parameter avalon_bus_type STRING {Memory Mapped}
add_parameter AUTO_CLK_CLOCK_RATE LONG 50000000
add_parameter TICK INTEGER 64
set_parameter_property TICK HDL_PARAMETER true
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_up_avalon_ps2

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_ps2_slave avalon end
set_interface_property avalon_ps2_slave associatedClock clk
set_interface_property avalon_ps2_slave associatedReset reset
foreach {name direction bits} {
    address Input 1 chipselect Input 1 byteenable Input 4 read Input 1 write Input 1
    writedata Input 32 readdata Output 32 waitrequest Output 1
} { add_interface_port avalon_ps2_slave $name $name $direction $bits }
add_interface interrupt interrupt end
set_interface_property interrupt associatedAddressablePoint avalon_ps2_slave
add_interface_port interrupt irq irq Output 1
add_interface external_interface conduit end
add_interface_port external_interface PS2_CLK CLK Bidir 1
add_interface_port external_interface PS2_DAT DAT Bidir 1

proc elaborate {} {
    if {[get_parameter_value avalon_bus_type] ne "Memory Mapped"} {
        send_message error "avalon_bus_type is \"[get_parameter_value avalon_bus_type]\", of which\
            only Memory Mapped can be simulated"
    }
    set rate [get_parameter_value AUTO_CLK_CLOCK_RATE]
    if {$rate > 0} { set_parameter_value TICK [expr {max(1, int(round($rate * 1.28e-6)))}] }
}
