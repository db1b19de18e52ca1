set_module_property NAME altera_avalon_mutex
set_module_property ELABORATION_CALLBACK elaborate
foreach {name hdl} {initialValue VALUE_INIT initialOwner OWNER_INIT} {
    add_parameter $name INTEGER 0
    add_parameter $hdl INTEGER 0
    set_parameter_property $hdl HDL_PARAMETER true
    set_parameter_property $hdl WIDTH 16
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_mutex

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
    address address Input 1                 chipselect chipselect Input 1
    read read Input 1                       write write Input 1
    data_from_cpu writedata Input 32        data_to_cpu readdata Output 32
} { add_interface_port s1 $port $role $direction $bits }

proc elaborate {} {
    foreach {name hdl} {initialValue VALUE_INIT initialOwner OWNER_INIT} {
        set value [get_parameter_value $name]
        if {$value < 0 || $value > 65535} {
            send_message error "$name is $value, expected 0 to 65,535"
        }
        set_parameter_value $hdl $value
        set_module_assignment embeddedsw.CMacro.$hdl $value
    }
    set_module_assignment embeddedsw.CMacro.VALUE_WIDTH 16
    set_module_assignment embeddedsw.CMacro.OWNER_WIDTH 16
}
