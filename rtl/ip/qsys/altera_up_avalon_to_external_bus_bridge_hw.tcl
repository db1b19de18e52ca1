set_module_property NAME altera_up_avalon_to_external_bus_bridge
set_module_property ELABORATION_CALLBACK elaborate
add_parameter addr_size INTEGER 4
add_parameter addr_size_multiplier STRING Kbytes
add_parameter data_size INTEGER 16
foreach {name value} {ADDRESS 11 SHIFT 1 WIDTH 16} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_up_avalon_to_external_bus_bridge

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_slave avalon end
set_interface_property avalon_slave associatedClock clk
set_interface_property avalon_slave associatedReset reset
foreach {role direction bits} {
    address Input ADDRESS     byteenable Input WIDTH/8  chipselect Input 1   read Input 1
    write Input 1             writedata Input WIDTH     readdata Output WIDTH
    waitrequest Output 1
} { add_interface_port avalon_slave avalon_$role $role $direction $bits }
add_interface interrupt interrupt end
set_interface_property interrupt associatedAddressablePoint avalon_slave
add_interface_port interrupt avalon_irq irq Output 1
add_interface external_interface conduit end
foreach {name direction bits} {
    acknowledge Input 1       irq Input 1               address Output ADDRESS+SHIFT
    bus_enable Output 1       byte_enable Output WIDTH/8  rw Output 1
    write_data Output WIDTH   read_data Input WIDTH
} { add_interface_port external_interface $name export $direction $bits }

proc elaborate {} {
    set bits [get_parameter_value data_size]
    if {$bits ni {8 16 32 64 128}} {
        send_message error "data_size is $bits, expected 8, 16, 32, 64 or 128"
    }
    set unit [get_parameter_value addr_size_multiplier]
    if {$unit ni {bytes Kbytes Mbytes}} {
        send_message error "addr_size_multiplier is \"$unit\", expected bytes, Kbytes or Mbytes"
    }
    set bytes [expr {[get_parameter_value addr_size] << 10 * [lsearch {bytes Kbytes Mbytes} $unit]}]
    if {$bytes < $bits / 4 || $bytes > 1 << 30} {
        send_message error "addr_size is $bytes bytes, expected two words to 1 Gbyte"
    }
    set shift [expr {int(round(log($bits / 8) / log(2)))}]
    set_parameter_value SHIFT $shift
    set_parameter_value WIDTH $bits
    set_parameter_value ADDRESS [expr {int(ceil(log($bytes) / log(2) - 1e-9)) - $shift}]
}
