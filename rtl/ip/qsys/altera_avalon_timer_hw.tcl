set_module_property NAME altera_avalon_timer
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    alwaysRun BOOLEAN false        counterSize INTEGER 32         fixedPeriod BOOLEAN false
    period STRING 1                periodUnits STRING MSEC        resetOutput BOOLEAN false
    snapshot BOOLEAN true          timeoutPulseOutput BOOLEAN false
    systemFrequency LONG 0         timerPreset STRING FULL_FEATURED
} {
    add_parameter $name $type $value
}
foreach {name type value} {SIZE INTEGER 32 LOAD STD_LOGIC_VECTOR 0 ALWAYS_RUN BOOLEAN false
                           FIXED_PERIOD BOOLEAN false SNAPSHOT BOOLEAN true} {
    add_parameter $name $type $value
    set_parameter_property $name HDL_PARAMETER true
}
set_parameter_property LOAD WIDTH 64
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_timer
set_module_assignment embeddedsw.dts.compatible ALTR,timer-1.0
set_module_assignment embeddedsw.dts.vendor altr
set_module_assignment embeddedsw.dts.name timer
set_module_assignment embeddedsw.dts.group timer

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset_n reset_n Input 1
add_interface s1 avalon end
set_interface_property s1 associatedClock clk
set_interface_property s1 associatedReset reset
set_interface_property s1 addressAlignment NATIVE
set_interface_property s1 readWaitTime 1
add_interface irq interrupt end
set_interface_property irq associatedAddressablePoint s1
add_interface_port irq irq irq Output 1

proc elaborate {} {
    set size [get_parameter_value counterSize]
    set_parameter_value SIZE $size
    foreach {to from} {ALWAYS_RUN alwaysRun FIXED_PERIOD fixedPeriod SNAPSHOT snapshot} {
        set_parameter_value $to [string is true [get_parameter_value $from]]
    }
    set period [get_parameter_value period]
    set hertz [get_parameter_value systemFrequency]
    set units {CLOCKS 1 USEC 1000000 MSEC 1000 SEC 1}
    set unit [string toupper [get_parameter_value periodUnits]]
    if {$unit eq "CLOCKS"} {
        set clocks [expr {entier($period)}]
    } elseif {$hertz == 0} {
        send_message error "its systemFrequency is 0, so $period $unit are no number of clocks"
    } else {
        set clocks [expr {entier(floor($period * $hertz / [dict get $units $unit]))}]
    }
    set_parameter_value LOAD [expr {$clocks > 1 ? $clocks - 1 : 1}]

    add_interface_port s1 address address Input [expr {$size == 64 ? 4 : 3}]
    add_interface_port s1 chipselect chipselect Input 1
    add_interface_port s1 write_n write_n Input 1
    add_interface_port s1 writedata writedata Input 16
    add_interface_port s1 readdata readdata Output 16
    foreach {property port role} {timeoutPulseOutput timeout_pulse timeout_pulse
                                  resetOutput resetrequest reset} {
        if {![string is true [get_parameter_value $property]]} continue
        if {$property eq "resetOutput"} {
            add_interface resetrequest reset start
            set_interface_property resetrequest associatedClock clk
            add_interface_port resetrequest $port $role Output 1
        } else {
            add_interface external_port conduit end
            add_interface_port external_port $port export Output 1
        }
    }
}
