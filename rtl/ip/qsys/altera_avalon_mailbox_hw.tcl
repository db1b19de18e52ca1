set_module_property NAME altera_avalon_mailbox
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_mailbox

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset_n reset_n Input 1
add_interface s1 avalon end
foreach {property value} {
    associatedClock clk associatedReset reset addressAlignment NATIVE readWaitTime 0
} { set_interface_property s1 $property $value }
foreach {port role direction bits} {
    address address Input 2                 chipselect chipselect Input 1
    read read Input 1                       write write Input 1
    data_from_cpu writedata Input 32        data_to_cpu readdata Output 32
} { add_interface_port s1 $port $role $direction $bits }
