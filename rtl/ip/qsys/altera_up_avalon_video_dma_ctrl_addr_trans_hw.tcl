set_module_property NAME altera_up_avalon_video_dma_ctrl_addr_trans
add_parameter ADDRESS_TRANSLATION_MASK LONG 3221225472
set_parameter_property ADDRESS_TRANSLATION_MASK HDL_PARAMETER true
set_parameter_property ADDRESS_TRANSLATION_MASK WIDTH 32
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_up_avalon_video_dma_ctrl_addr_trans

add_interface clock clock end
add_interface_port clock clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clock
add_interface_port reset reset reset Input 1
add_interface slave avalon end
add_interface master avalon start
foreach {name into out} {slave Input Output master Output Input} {
    set_interface_property $name associatedClock clock
    set_interface_property $name associatedReset reset
    foreach {role direction bits} "
        address $into [expr {$name eq {slave} ? 2 : 32}] byteenable $into 4 read $into 1
        write $into 1 readdata $out 32 writedata $into 32 waitrequest $out 1
    " { add_interface_port $name ${name}_$role $role $direction $bits }
}
set_interface_property slave bridgesToMaster master
