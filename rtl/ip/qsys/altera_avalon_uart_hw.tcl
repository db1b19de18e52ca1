set_module_property NAME altera_avalon_uart
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    baud LONG 115200         clockRate LONG 0           dataBits INTEGER 8     stopBits INTEGER 1
    parity STRING NONE       fixedBaud BOOLEAN true     syncRegDepth INTEGER 2
    useCtsRts BOOLEAN false  useEopRegister BOOLEAN false
} { add_parameter $name $type $value }
foreach {name value} {DIVISOR 433 FIXED 1 DATA 8 PARITY 0 STOP 1 EOP 0 CTS_RTS 0} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_uart
set_module_assignment embeddedsw.dts.vendor altr
set_module_assignment embeddedsw.dts.name uart
set_module_assignment embeddedsw.dts.group serial
set_module_assignment embeddedsw.dts.compatible {ALTR,uart-1.0}

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset_n reset_n Input 1
add_interface s1 avalon end
foreach {property value} {
    associatedClock clk associatedReset reset addressAlignment NATIVE readLatency 1 readWaitTime 0
} { set_interface_property s1 $property $value }
foreach {role direction bits} {
    address Input 3       chipselect Input 1     read_n Input 1      write_n Input 1
    writedata Input 16    readdata Output 16
} { add_interface_port s1 $role $role $direction $bits }
add_interface irq interrupt end
set_interface_property irq associatedAddressablePoint s1
add_interface_port irq irq irq Output 1
add_interface external_connection conduit end
add_interface_port external_connection rxd rxd Input 1
add_interface_port external_connection txd txd Output 1

proc elaborate {} {
    set rate [get_parameter_value clockRate]
    if {$rate <= 0} { set rate 50000000 }
    set baud [get_parameter_value baud]
    set divisor [expr {$baud > 0 ? int(round(double($rate) / $baud)) - 1 : 0}]
    if {$divisor < 7 || $divisor > 65535} {
        send_message error "baud is $baud, expected an 8th to a 65,536th of the clock's $rate Hz"
    }
    set parity [lsearch {NONE ODD EVEN} [get_parameter_value parity]]
    if {$parity < 0} {
        send_message error "parity is \"[get_parameter_value parity]\", expected NONE, ODD or EVEN"
    }
    set cts [string is true [get_parameter_value useCtsRts]]
    foreach {name value} "
        DIVISOR $divisor PARITY $parity CTS_RTS $cts
        FIXED [string is true [get_parameter_value fixedBaud]]
        DATA [get_parameter_value dataBits] STOP [get_parameter_value stopBits]
        EOP [string is true [get_parameter_value useEopRegister]]
    " { set_parameter_value $name $value }
    if {$cts} {
        add_interface_port external_connection cts_n cts_n Input 1
        add_interface_port external_connection rts_n rts_n Output 1
    }
}
