set_module_property NAME altera_up_external_bus_to_avalon_bridge
set_module_property ELABORATION_CALLBACK elaborate
add_parameter addr_size INTEGER 4
add_parameter addr_size_multiplier STRING Kbytes
add_parameter data_size INTEGER 16
foreach {name value} {ADDRESS 12 WIDTH 16} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_up_external_bus_to_avalon_bridge

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_master avalon start
set_interface_property avalon_master associatedClock clk
set_interface_property avalon_master associatedReset reset
foreach {role direction bits} {
    readdata Input WIDTH      waitrequest Input 1       byteenable Output WIDTH/8
    read Output 1             write Output 1            writedata Output WIDTH
    address Output ADDRESS
} { add_interface_port avalon_master avalon_$role $role $direction $bits }
add_interface external_interface conduit end
foreach {name direction bits} {
    address Input ADDRESS     byte_enable Input WIDTH/8 read Input 1         write Input 1
    write_data Input WIDTH    acknowledge Output 1      read_data Output WIDTH
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
    set_parameter_value WIDTH $bits
    set_parameter_value ADDRESS [expr {int(ceil(log($bytes) / log(2) - 1e-9))}]
}
