set_module_property NAME altera_generic_tristate_controller
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value} {
    TCM_ADDRESS_W 32 TCM_DATA_W 32 TCM_BYTEENABLE_W 4 TCM_READ_WAIT 0 TCM_WRITE_WAIT 0
    TCM_SETUP_WAIT 0 TCM_DATA_HOLD 0 TCM_MAX_PENDING_READ_TRANSACTIONS 3 TCM_TURNAROUND_TIME 2
    TCM_TIMING_UNITS 1 TCM_READLATENCY 2 TCM_SYMBOLS_PER_WORD 4
    USE_READDATA 1 USE_WRITEDATA 1 USE_READ 1 USE_WRITE 1 USE_BEGINTRANSFER 0 USE_BYTEENABLE 0
    USE_CHIPSELECT 0 USE_LOCK 0 USE_ADDRESS 1 USE_WAITREQUEST 0 USE_WRITEBYTEENABLE 0
    USE_OUTPUTENABLE 0 USE_RESETREQUEST 0 USE_IRQ 0 USE_RESET_OUTPUT 0
    ACTIVE_LOW_READ 0 ACTIVE_LOW_LOCK 0 ACTIVE_LOW_WRITE 0 ACTIVE_LOW_CHIPSELECT 0
    ACTIVE_LOW_BYTEENABLE 0 ACTIVE_LOW_OUTPUTENABLE 0 ACTIVE_LOW_WRITEBYTEENABLE 0
    ACTIVE_LOW_WAITREQUEST 0 ACTIVE_LOW_BEGINTRANSFER 0 ACTIVE_LOW_RESETREQUEST 0 ACTIVE_LOW_IRQ 0
    ACTIVE_LOW_RESET_OUTPUT 0 CHIPSELECT_THROUGH_READLATENCY 0 IS_MEMORY_DEVICE 0
    ADDRESS 21 WIDTH 16 SETUP 0 READ_WAIT 1 WRITE_WAIT 0 HOLD 0 TURNAROUND 2 LATENCY 2 WAITS 0
    SELECTED 0
} { add_parameter $name INTEGER $value }
add_parameter CLOCK_RATE LONG 0
foreach name {
    ADDRESS WIDTH SETUP READ_WAIT WRITE_WAIT HOLD TURNAROUND LATENCY WAITS SELECTED
} { set_parameter_property $name HDL_PARAMETER true }
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_generic_tristate_controller

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface uas avalon end
foreach {property value} {associatedClock clk associatedReset reset addressUnits SYMBOLS} {
    set_interface_property uas $property $value
}
add_interface tcm tristate_conduit start

proc elaborate {} {
    foreach name {USE_LOCK USE_RESETREQUEST USE_IRQ} {
        if {[get_parameter_value $name]} {
            send_message error "$name is [get_parameter_value $name], expected 0: not simulated"
        }
    }
    # Times in ns become whole clocks.
    set rate [get_parameter_value CLOCK_RATE]
    set in_clocks [get_parameter_value TCM_TIMING_UNITS]
    if {!$in_clocks && $rate <= 0} {
        send_message error "CLOCK_RATE is $rate, expected the clock's Hz, since times are in ns"
        set rate 1
    }
    foreach {name of} {SETUP TCM_SETUP_WAIT READ_WAIT TCM_READ_WAIT WRITE_WAIT TCM_WRITE_WAIT
                       HOLD TCM_DATA_HOLD TURNAROUND TCM_TURNAROUND_TIME} {
        set time [get_parameter_value $of]
        if {!$in_clocks} { set time [expr {int(ceil($time * double($rate) / 1e9))}] }
        set_parameter_value $name $time
    }
    set width [get_parameter_value TCM_DATA_W]
    set address [get_parameter_value TCM_ADDRESS_W]
    set bytes [expr {$width / 8}]
    set waits [get_parameter_value USE_WAITREQUEST]
    foreach {name value} [list ADDRESS $address WIDTH $width WAITS $waits \
                LATENCY [get_parameter_value TCM_READLATENCY] \
                SELECTED [get_parameter_value CHIPSELECT_THROUGH_READLATENCY]] {
        set_parameter_value $name $value
    }
    set_interface_property uas maximumPendingReadTransactions \
        [get_parameter_value TCM_MAX_PENDING_READ_TRANSACTIONS]
    foreach {role direction bits} "
        address Input $address   read Input 1              write Input 1
        byteenable Input $bytes  writedata Input $width    readdata Output $width
        readdatavalid Output 1   waitrequest Output 1
    " { add_interface_port uas uas_$role $role $direction $bits }

    add_interface_port tcm tcm_request request Output 1
    add_interface_port tcm tcm_grant grant Input 1
    foreach {use role bits} "
        READ read 1              WRITE write 1           CHIPSELECT chipselect 1
        OUTPUTENABLE outputenable 1                      BEGINTRANSFER begintransfer 1
        BYTEENABLE byteenable $bytes                     WRITEBYTEENABLE writebyteenable $bytes
        RESET_OUTPUT reset 1
    " {
        if {![get_parameter_value USE_$use]} { continue }
        if {[get_parameter_value ACTIVE_LOW_$use]} { append role _n }
        add_interface_port tcm tcm_${role}_out ${role}_out Output $bits
    }
    if {[get_parameter_value USE_ADDRESS]} {
        add_interface_port tcm tcm_address_out address_out Output $address
    }
    if {[get_parameter_value USE_WRITEDATA]} {
        add_interface_port tcm tcm_data_out data_out Output $width
        add_interface_port tcm tcm_data_outen data_outen Output 1
    }
    if {[get_parameter_value USE_READDATA]} {
        add_interface_port tcm tcm_data_in data_in Input $width
    }
    if {$waits} {
        if {[get_parameter_value ACTIVE_LOW_WAITREQUEST]} {
            send_message error "ACTIVE_LOW_WAITREQUEST is 1, expected 0: not simulated"
        }
        add_interface_port tcm tcm_waitrequest_in waitrequest_in Input 1
    }
}
