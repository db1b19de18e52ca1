set_module_property NAME altera_avalon_pio
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value hdl} {
    width INTEGER 8 true                     direction STRING Output false
    resetValue LONG 0 true                   captureEdge BOOLEAN false true
    edgeType STRING RISING true              generateIRQ BOOLEAN false true
    irqType STRING LEVEL true                bitClearingEdgeCapReg BOOLEAN false true
    bitModifyingOutReg BOOLEAN false true
} {
    add_parameter $name $type $value
    set_parameter_property $name HDL_PARAMETER $hdl
}
set_parameter_property resetValue WIDTH 32
add_parameter has_input BOOLEAN true
add_parameter has_output BOOLEAN true
add_parameter is_bidir BOOLEAN false
foreach name {has_input has_output is_bidir} { set_parameter_property $name HDL_PARAMETER true }
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_pio
set_module_assignment embeddedsw.dts.compatible altr,pio-1.0
set_module_assignment embeddedsw.dts.vendor altr
set_module_assignment embeddedsw.dts.name pio
set_module_assignment embeddedsw.dts.group gpio

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset_n reset_n Input 1
add_interface s1 avalon end
set_interface_property s1 associatedClock clk
set_interface_property s1 associatedReset reset
set_interface_property s1 readWaitTime 1
add_interface external_connection conduit end

proc elaborate {} {
    set direction [string tolower [get_parameter_value direction]]
    set width [get_parameter_value width]
    set edges [string is true [get_parameter_value captureEdge]]
    set irq [string is true [get_parameter_value generateIRQ]]
    set modifies [string is true [get_parameter_value bitModifyingOutReg]]
    set_parameter_value has_input [expr {$direction ne "output"}]
    set_parameter_value has_output [expr {$direction ne "input"}]
    set_parameter_value is_bidir [expr {$direction eq "bidir"}]
    foreach {name value} [list DATA_WIDTH $width CAPTURE $edges \
                              HAS_IN [expr {$direction ne "output"}] \
                              HAS_OUT [expr {$direction ne "input"}] \
                              HAS_TRI [expr {$direction eq "bidir"}] \
                              EDGE_TYPE [expr {$edges ? [get_parameter_value edgeType] : "NONE"}] \
                              IRQ_TYPE [expr {$irq ? [get_parameter_value irqType] : "NONE"}] \
                              RESET_VALUE [get_parameter_value resetValue] \
                              BIT_MODIFYING_OUTPUT_REGISTER $modifies] {
        set_module_assignment embeddedsw.CMacro.$name $value
    }

    add_interface_port s1 address address Input [expr {$modifies && $direction ne "input" ? 3 : 2}]
    if {$direction ne "input" || $edges || $irq} {
        add_interface_port s1 write_n write_n Input 1
        add_interface_port s1 writedata writedata Input 32
        add_interface_port s1 chipselect chipselect Input 1
    }
    add_interface_port s1 readdata readdata Output 32
    switch $direction {
        input  { add_interface_port external_connection in_port export Input $width }
        output { add_interface_port external_connection out_port export Output $width }
        bidir  { add_interface_port external_connection bidir_port export Bidir $width }
        inout {
            add_interface_port external_connection in_port in_port Input $width
            add_interface_port external_connection out_port out_port Output $width
        }
    }
    if {$irq} {
        add_interface irq interrupt end
        set_interface_property irq associatedAddressablePoint s1
        add_interface_port irq irq irq Output 1
    }
}
