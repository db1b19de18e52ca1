set_module_property NAME altera_avalon_sysid_qsys
set_module_property ELABORATION_CALLBACK elaborate
add_parameter id INTEGER 0
set_parameter_property id WIDTH 32
set_parameter_property id HDL_PARAMETER true
add_parameter timestamp INTEGER 0
set_parameter_property timestamp WIDTH 32
set_parameter_property timestamp HDL_PARAMETER true
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_sysid_qsys
set_module_assignment embeddedsw.dts.compatible ALTR,sysid-1.0
set_module_assignment embeddedsw.dts.vendor altr
set_module_assignment embeddedsw.dts.name sysid
set_module_assignment embeddedsw.dts.group sysid

add_interface clk clock end
add_interface_port clk clock clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset_n reset_n Input 1
add_interface control_slave avalon end
set_interface_property control_slave associatedClock clk
set_interface_property control_slave associatedReset reset
set_interface_property control_slave readWaitTime 1
add_interface_port control_slave readdata readdata Output 32
add_interface_port control_slave address address Input 1

proc elaborate {} {}
