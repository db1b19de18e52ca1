set_module_property NAME altera_avalon_spi
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    clockPhase INTEGER 0              clockPolarity INTEGER 0         dataWidth INTEGER 8
    disableAvalonFlowControl BOOLEAN false                            inputClockRate LONG 0
    insertDelayBetweenSlaveSelectAndSClk BOOLEAN false                insertSync BOOLEAN false
    lsbOrderedFirst BOOLEAN false     masterSPI BOOLEAN true          numberOfSlaves INTEGER 1
    syncRegDepth INTEGER 2            targetClockRate LONG 128000
    targetSlaveSelectToSClkDelay FLOAT 0.0
} { add_parameter $name $type $value }
foreach {name value} {
    MASTER 1 BITS 8 WIDTH 16 SLAVES 1 CPOL 0 CPHA 0 LSB 0 HALF 195 LEAD 1 SYNC 1
} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_spi
set_module_assignment embeddedsw.dts.vendor altr
set_module_assignment embeddedsw.dts.name spi
set_module_assignment embeddedsw.dts.group spi
set_module_assignment embeddedsw.dts.compatible altr,spi-1.0

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset_n reset_n Input 1
add_interface spi_control_port avalon end
foreach {property value} {
    associatedClock clk associatedReset reset addressAlignment NATIVE
    readWaitTime 1 writeWaitTime 1
} { set_interface_property spi_control_port $property $value }
foreach {port role direction bits} {
    data_from_cpu writedata Input WIDTH   data_to_cpu readdata Output WIDTH
    mem_addr address Input 3              read_n read_n Input 1
    spi_select chipselect Input 1         write_n write_n Input 1
} { add_interface_port spi_control_port $port $role $direction $bits }
add_interface irq interrupt end
set_interface_property irq associatedAddressablePoint spi_control_port
add_interface_port irq irq irq Output 1
add_interface external conduit end

proc on {name} { string is true [get_parameter_value $name] }

proc elaborate {} {
    foreach {name least most} {dataWidth 1 32 numberOfSlaves 1 32} {
        set value [get_parameter_value $name]
        if {$value < $least || $value > $most} {
            send_message error "$name is $value, expected $least to $most"
        }
    }
    set rate [get_parameter_value inputClockRate]
    if {$rate <= 0} { set rate 50000000 }
    set target [get_parameter_value targetClockRate]
    if {$target <= 0} { send_message error "targetClockRate is $target, expected more than 0" }
    # The rate is the next lower one that is an even part of the clock's.
    set half [expr {int(ceil(ceil($rate / double($target)) / 2))}]
    set lead 1
    if {[on insertDelayBetweenSlaveSelectAndSClk]} {
        set ns [get_parameter_value targetSlaveSelectToSClkDelay]
        set lead [expr {max(1, int(ceil($ns * $rate / 1e9 / $half)))}]
    }
    set bits [get_parameter_value dataWidth]
    set width [expr {$bits > 16 ? 32 : 16}]
    set slaves [expr {[on masterSPI] ? [get_parameter_value numberOfSlaves] : 1}]
    foreach {name value} "
        MASTER [on masterSPI]  BITS $bits  WIDTH $width  SLAVES $slaves  HALF $half  LEAD $lead
        CPOL [get_parameter_value clockPolarity]  CPHA [get_parameter_value clockPhase]
        LSB [on lsbOrderedFirst]  SYNC [expr {[on insertSync] ? [get_parameter_value syncRegDepth]
                                              : 1}]
    " { set_parameter_value $name $value }
    foreach {macro value} "
        CLOCKPHASE [get_parameter_value clockPhase]  ISMASTER [on masterSPI]
        CLOCKPOLARITY [get_parameter_value clockPolarity]  DATABITS $bits  DATAWIDTH $width
        LSBFIRST [on lsbOrderedFirst]  NUMSLAVES [get_parameter_value numberOfSlaves]
        EXTRADELAY [on insertDelayBetweenSlaveSelectAndSClk]  TARGETCLOCK ${target}u
    " { set_module_assignment embeddedsw.CMacro.$macro $value }
    if {[on masterSPI]} {
        foreach {port role direction bits} "
            miso_i MISO Input 1 mosi_o MOSI Output 1 sclk_o SCLK Output 1 ss_no SS_n Output $slaves
        " { add_interface_port external $port $role $direction $bits }
    } else {
        foreach {port role direction} {
            miso_o MISO Output mosi_i MOSI Input sclk_i SCLK Input ss_ni SS_n Input
        } { add_interface_port external $port $role $direction 1 }
    }
}
