set_module_property NAME altera_avalon_new_sdram_controller
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value hdl} {
    dataWidth INTEGER 16 true      rowWidth INTEGER 13 true
    columnWidth INTEGER 10 true    casLatency INTEGER 3 true
    numberOfBanks INTEGER 4 false  numberOfChipSelects INTEGER 1 false
    clockRate LONG 0 false         initRefreshCommands INTEGER 2 false
    powerUpDelay FLOAT 100.0 false refreshPeriod FLOAT 15.625 false
    TRP FLOAT 20.0 false           TRCD FLOAT 20.0 false
    TRFC FLOAT 70.0 false          TWR FLOAT 14.0 false
    TMRD FLOAT 3 false             pinsSharedViaTriState BOOLEAN false false
    POWER_UP LONG 0 true           REFRESH LONG 0 true
    T_RP INTEGER 0 true            T_RCD INTEGER 0 true
    T_RFC INTEGER 0 true           T_WR INTEGER 0 true
    T_MRD INTEGER 0 true           INIT_REFRESHES INTEGER 2 true
} {
    add_parameter $name $type $value
    set_parameter_property $name HDL_PARAMETER $hdl
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_new_sdram_controller
set_module_assignment embeddedsw.dts.vendor altr
set_module_assignment embeddedsw.dts.name sdram
set_module_assignment embeddedsw.dts.group memory

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset_n reset_n Input 1
add_interface s1 avalon end
foreach {property value} {
    associatedClock clk associatedReset reset readWaitTime 1 maximumPendingReadTransactions 7
} { set_interface_property s1 $property $value }
add_interface wire conduit end

proc clocks {ns mhz} { return [expr {int(ceil($ns * $mhz / 1000.0))}] }

proc elaborate {} {
    foreach {name expected} {numberOfBanks 4 numberOfChipSelects 1} {
        if {[get_parameter_value $name] != $expected} {
            send_message error "$name is [get_parameter_value $name], expected $expected"
        }
    }
    # Without the clock's rate, that of the fastest.
    set mhz [expr {[get_parameter_value clockRate] / 1e6}]
    if {$mhz <= 0} { set mhz 143 }
    set_parameter_value POWER_UP [clocks [expr {[get_parameter_value powerUpDelay] * 1000}] $mhz]
    set_parameter_value REFRESH \
        [expr {[clocks [expr {[get_parameter_value refreshPeriod] * 1000}] $mhz] - 20}]
    foreach {clocks ns} {T_RP TRP T_RCD TRCD T_RFC TRFC T_WR TWR} {
        set_parameter_value $clocks [clocks [get_parameter_value $ns] $mhz]
    }
    set_parameter_value T_MRD [expr {int([get_parameter_value TMRD])}]
    set_parameter_value INIT_REFRESHES [get_parameter_value initRefreshCommands]

    set width [get_parameter_value dataWidth]
    set bytes [expr {$width / 8}]
    set rows [get_parameter_value rowWidth]
    set address [expr {2 + $rows + [get_parameter_value columnWidth]}]
    foreach {name role direction bits} "
        az_addr address Input $address      az_be_n byteenable_n Input $bytes
        az_cs chipselect Input 1            az_data writedata Input $width
        az_rd_n read_n Input 1              az_wr_n write_n Input 1
        za_data readdata Output $width      za_valid readdatavalid Output 1
        za_waitrequest waitrequest Output 1
    " { add_interface_port s1 $name $role $direction $bits }
    foreach {name role direction bits} "
        zs_addr addr Output $rows  zs_ba ba Output 2      zs_cas_n cas_n Output 1
        zs_cke cke Output 1        zs_cs_n cs_n Output 1  zs_dq dq Bidir $width
        zs_dqm dqm Output $bytes   zs_ras_n ras_n Output 1 zs_we_n we_n Output 1
    " {
        add_interface_port wire $name $role $direction $bits
        if {$bits > 1} { set_port_property $name VHDL_TYPE STD_LOGIC_VECTOR }
    }
}
