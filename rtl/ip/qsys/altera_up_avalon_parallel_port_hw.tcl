set_module_property NAME altera_up_avalon_parallel_port
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    board STRING DE1-SoC      custom_port BOOLEAN false    preset STRING Pushbuttons
    custom_DW INTEGER 32      custom_direction STRING {Input only}
    capture BOOLEAN false     edge STRING Rising           irq BOOLEAN false
    irq_type STRING Edge      gpio STRING {GPIO 0 (JP1)}   leds STRING Green
    sevensegs STRING {3 to 0}
} { add_parameter $name $type $value }
foreach {name type value} {
    WIDTH INTEGER 32          DIRECTION STRING {Input only}   EDGE STRING Rising
    CAPTURES INTEGER 0        IRQ STRING None
} {
    add_parameter $name $type $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_up_avalon_parallel_port

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_parallel_port_slave avalon end
foreach {property value} {
    associatedClock clk associatedReset reset readLatency 1 readWaitTime 0
} { set_interface_property avalon_parallel_port_slave $property $value }
foreach {name direction bits} {
    address Input 2       byteenable Input 4    chipselect Input 1   read Input 1
    write Input 1         writedata Input 32    readdata Output 32
} { add_interface_port avalon_parallel_port_slave $name $name $direction $bits }
add_interface external_interface conduit end

proc elaborate {} {
    if {![string is true [get_parameter_value custom_port]]} {
        send_message error "it is preset for [get_parameter_value preset], of which only a custom\
            port can be simulated: set custom_port, its width and its direction"
    }
    set width [get_parameter_value custom_DW]
    set direction [get_parameter_value custom_direction]
    set interrupts [string is true [get_parameter_value irq]]
    set_parameter_value WIDTH $width
    set_parameter_value DIRECTION $direction
    set_parameter_value EDGE [get_parameter_value edge]
    set_parameter_value CAPTURES [string is true [get_parameter_value capture]]
    set_parameter_value IRQ [expr {$interrupts ? [get_parameter_value irq_type] : "None"}]
    switch $direction {
        "Input only"    { add_interface_port external_interface in_port export Input $width }
        "Output only"   { add_interface_port external_interface out_port export Output $width }
        Bidirectional   { add_interface_port external_interface bidir_port export Bidir $width }
        default         { send_message error "custom_direction is \"$direction\", expected Input\
                              only, Output only or Bidirectional" }
    }
    if {$interrupts} {
        add_interface interrupt interrupt end
        set_interface_property interrupt associatedAddressablePoint avalon_parallel_port_slave
        add_interface_port interrupt irq irq Output 1
    }
}
