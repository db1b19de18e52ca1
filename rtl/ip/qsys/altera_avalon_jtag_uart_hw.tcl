set_module_property NAME altera_avalon_jtag_uart
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value to} {
    readBufferDepth INTEGER 64 READ_DEPTH     readIRQThreshold INTEGER 8 READ_THRESHOLD
    writeBufferDepth INTEGER 64 WRITE_DEPTH   writeIRQThreshold INTEGER 8 WRITE_THRESHOLD
} {
    add_parameter $name $type $value
    add_parameter $to $type $value
    set_parameter_property $to HDL_PARAMETER true
}
foreach {name type value} {
    allowMultipleConnections BOOLEAN false     hubInstanceID INTEGER 0
    simInputCharacterStream STRING {}          simInteractiveOptions STRING NO_INTERACTIVE_WINDOWS
    useRegistersForReadBuffer BOOLEAN false    useRegistersForWriteBuffer BOOLEAN false
    useRelativePathForSimFile BOOLEAN false
} {
    add_parameter $name $type $value
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_jtag_uart
set_module_assignment embeddedsw.dts.compatible altr,juart-1.0
set_module_assignment embeddedsw.dts.vendor altr
set_module_assignment embeddedsw.dts.name juart
set_module_assignment embeddedsw.dts.group serial

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset rst_n reset_n Input 1
add_interface avalon_jtag_slave avalon end
set_interface_property avalon_jtag_slave associatedClock clk
set_interface_property avalon_jtag_slave associatedReset reset
set_interface_property avalon_jtag_slave addressAlignment NATIVE
set_interface_property avalon_jtag_slave readWaitTime 1
add_interface_port avalon_jtag_slave av_chipselect chipselect Input 1
add_interface_port avalon_jtag_slave av_address address Input 1
add_interface_port avalon_jtag_slave av_read_n read_n Input 1
add_interface_port avalon_jtag_slave av_readdata readdata Output 32
add_interface_port avalon_jtag_slave av_write_n write_n Input 1
add_interface_port avalon_jtag_slave av_writedata writedata Input 32
add_interface_port avalon_jtag_slave av_waitrequest waitrequest Output 1
add_interface irq interrupt end
set_interface_property irq associatedAddressablePoint avalon_jtag_slave
add_interface_port irq av_irq irq Output 1

proc elaborate {} {
    foreach {from to} {readBufferDepth READ_DEPTH readIRQThreshold READ_THRESHOLD
                       writeBufferDepth WRITE_DEPTH writeIRQThreshold WRITE_THRESHOLD} {
        set_parameter_value $to [get_parameter_value $from]
    }
}
