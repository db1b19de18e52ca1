set_module_property NAME altera_avalon_dma
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    allowByteTransactions BOOLEAN true        allowHalfWordTransactions BOOLEAN true
    allowWordTransactions BOOLEAN true        allowDoubleWordTransactions BOOLEAN true
    allowQuadWordTransactions BOOLEAN true    bigEndian BOOLEAN false
    burstEnable BOOLEAN false                 maxBurstSize INTEGER 128
    fifoDepth INTEGER 32                      minimumDmaTransactionRegisterWidth INTEGER 13
    useRegistersForFIFO BOOLEAN false
} { add_parameter $name $type $value }
foreach {name value} {WIDTH 128 FIFO_LOG2 5 COUNT 8} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_dma

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset system_reset_n reset_n Input 1

proc value {name} { get_parameter_value $name }
proc on {name} { string is true [value $name] }

proc interface {name type end ports} {
    add_interface $name $type $end
    set_interface_property $name associatedClock clk
    set_interface_property $name associatedReset reset
    foreach {port role direction bits} $ports {
        if {$bits > 0} { add_interface_port $name $port $role $direction $bits }
    }
}

proc elaborate {} {
    set width 0
    foreach {name bits} {Byte 8 HalfWord 16 Word 32 DoubleWord 64 QuadWord 128} {
        if {[on allow${name}Transactions]} { set width $bits }
        set_module_assignment embeddedsw.CMacro.ALLOW_[string map {HALFWORD HW} \
            [string toupper $name]]_TRANSACTIONS [on allow${name}Transactions]
    }
    if {$width == 0} { send_message error "no transactions are allowed: expected at least one kind" }
    if {[on bigEndian]} { send_message error "bigEndian cannot be simulated" }
    set depth [value fifoDepth]
    if {$depth < 4 || $depth > 4096 || $depth & ($depth - 1)} {
        send_message error "fifoDepth is $depth, expected a power of two, 4 to 4096"
    }
    for {set log2 2} {1 << $log2 < $depth} {incr log2} {}
    for {set count 1} {1 << ($count - 1) < [value maxBurstSize]} {incr count} {}
    foreach {name value} [list WIDTH $width FIFO_LOG2 $log2 COUNT $count] {
        set_parameter_value $name $value
    }
    set_module_assignment embeddedsw.CMacro.LENGTHWIDTH [value minimumDmaTransactionRegisterWidth]
    set_module_assignment embeddedsw.CMacro.MAX_BURST_SIZE [value maxBurstSize]

    interface control_port_slave avalon end {
        dma_ctl_address address Input 3 dma_ctl_chipselect chipselect Input 1
        dma_ctl_write_n write_n Input 1 dma_ctl_writedata writedata Input 32
        dma_ctl_readdata readdata Output 32
    }
    # The vendor's has writeWaitTime 1, and so sees a write for two clocks.
    foreach {property value} {
        addressAlignment NATIVE readWaitTime 1 writeWaitTime 0 readLatency 0
    } { set_interface_property control_port_slave $property $value }
    interface irq interrupt end {dma_ctl_irq irq Output 1}
    set_interface_property irq associatedAddressablePoint control_port_slave
    set lanes [expr {$width > 8 ? $width / 8 : 0}]
    set counts [expr {[on burstEnable] ? $count : 0}]
    interface read_master avalon start "
        read_address address Output 32 read_chipselect chipselect Output 1
        read_read_n read_n Output 1 read_byteenable byteenable Output $lanes
        read_burstcount burstcount Output $counts read_readdata readdata Input $width
        read_readdatavalid readdatavalid Input 1 read_waitrequest waitrequest Input 1
    "
    interface write_master avalon start "
        write_address address Output 32 write_chipselect chipselect Output 1
        write_write_n write_n Output 1 write_byteenable byteenable Output $lanes
        write_burstcount burstcount Output $counts write_writedata writedata Output $width
        write_waitrequest waitrequest Input 1
    "
}
