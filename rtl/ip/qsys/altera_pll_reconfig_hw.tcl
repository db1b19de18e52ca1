set_module_property NAME altera_pll_reconfig
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value hdl} {
    ENABLE_BYTEENABLE BOOLEAN false true    BYTEENABLE_WIDTH INTEGER 4 true
    ENABLE_MIF BOOLEAN false false          MIF_FILE_NAME STRING "" false
} {
    add_parameter $name $type $value
    set_parameter_property $name HDL_PARAMETER $hdl
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_pll_reconfig_top

add_interface mgmt_clk clock end
add_interface_port mgmt_clk mgmt_clk clk Input 1
add_interface mgmt_reset reset end
set_interface_property mgmt_reset associatedClock mgmt_clk
add_interface_port mgmt_reset mgmt_reset reset Input 1
add_interface mgmt_avalon_slave avalon end
set_interface_property mgmt_avalon_slave associatedClock mgmt_clk
set_interface_property mgmt_avalon_slave associatedReset mgmt_reset
foreach {role direction bits} {
    waitrequest Output 1      read Input 1        write Input 1         readdata Output 32
    address Input 6           writedata Input 32
} { add_interface_port mgmt_avalon_slave mgmt_$role $role $direction $bits }
foreach {name direction} {reconfig_to_pll Output reconfig_from_pll Input} {
    add_interface $name conduit end
    add_interface_port $name $name $name $direction 64
}

proc elaborate {} {
    if {[string is true [get_parameter_value ENABLE_MIF]]} {
        send_message error "ENABLE_MIF is set, but settings of a MIF are not simulated"
    }
    if {[string is true [get_parameter_value ENABLE_BYTEENABLE]]} {
        add_interface_port mgmt_avalon_slave mgmt_byteenable byteenable Input \
            [get_parameter_value BYTEENABLE_WIDTH]
    }
}
