set_module_property NAME altera_avalon_sgdma
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    addressWidth INTEGER 32                 alwaysDoMaxBurst BOOLEAN true
    avalonMMByteReorderMode INTEGER 0       dataTransferFIFODepth INTEGER 2
    enableBurstTransfers BOOLEAN false      enableDescriptorReadMasterBurst BOOLEAN false
    enableUnalignedTransfers BOOLEAN false  internalFIFODepth INTEGER 2
    readBlockDataWidth INTEGER 32           readBurstcountWidth INTEGER 4
    writeBurstcountWidth INTEGER 4          sinkErrorWidth INTEGER 0
    sourceErrorWidth INTEGER 0              transferMode STRING MEMORY_TO_MEMORY
} { add_parameter $name $type $value }
foreach {name value} {WIDTH 32 READS 1 WRITES 1 UNALIGNED 0 EMPTY 2 ERROR 1 COUNT 4} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_sgdma

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset system_reset_n reset_n Input 1

proc value {name} { get_parameter_value $name }
proc on {name} { string is true [value $name] }

# The ports have the interface's name before their role.
proc interface {name type end ports} {
    add_interface $name $type $end
    set_interface_property $name associatedClock clk
    set_interface_property $name associatedReset reset
    foreach {role direction bits} $ports {
        if {$bits > 0} { add_interface_port $name ${name}_$role $role $direction $bits }
    }
}

proc elaborate {} {
    set mode [value transferMode]
    if {$mode ni {MEMORY_TO_MEMORY MEMORY_TO_STREAM STREAM_TO_MEMORY}} {
        send_message error "transferMode is $mode, expected MEMORY_TO_MEMORY, MEMORY_TO_STREAM or\
            STREAM_TO_MEMORY"
    }
    set width [value readBlockDataWidth]
    if {$width ni {8 16 32 64}} {
        send_message error "readBlockDataWidth is $width, expected 8, 16, 32 or 64"
    }
    if {[value avalonMMByteReorderMode]} {
        send_message error "avalonMMByteReorderMode cannot be simulated"
    }
    set reads [expr {$mode ne "STREAM_TO_MEMORY"}]
    set writes [expr {$mode ne "MEMORY_TO_STREAM"}]
    for {set empty 0} {8 << $empty < $width} {incr empty} {}
    set error [value [expr {$reads ? "sourceErrorWidth" : "sinkErrorWidth"}]]
    set count [value [expr {$reads ? "readBurstcountWidth" : "writeBurstcountWidth"}]]
    set counts [expr {[on enableBurstTransfers] ? $count : 0}]
    foreach {name value} [list WIDTH $width READS $reads WRITES $writes EMPTY [expr {max($empty, 1)}] \
        UNALIGNED [on enableUnalignedTransfers] ERROR [expr {max($error, 1)}] COUNT $count] {
        set_parameter_value $name $value
    }

    interface csr avalon end {
        chipselect Input 1 address Input 4 read Input 1 write Input 1 writedata Input 32
        readdata Output 32
    }
    interface descriptor_read avalon start "
        address Output 32 read Output 1 readdata Input 32 readdatavalid Input 1 waitrequest Input 1
        burstcount Output [expr {[on enableDescriptorReadMasterBurst] ? 4 : 0}]
    "
    interface descriptor_write avalon start {
        address Output 32 write Output 1 writedata Output 32 waitrequest Input 1
    }
    interface csr_irq interrupt end {}
    add_interface_port csr_irq csr_irq irq Output 1
    set_interface_property csr_irq associatedAddressablePoint csr
    if {$reads} {
        interface m_read avalon start "
            address Output 32 read Output 1 readdata Input $width readdatavalid Input 1
            waitrequest Input 1 burstcount Output $counts
        "
    }
    if {$writes} {
        interface m_write avalon start "
            address Output 32 write Output 1 writedata Output $width waitrequest Input 1
            byteenable Output [expr {$width > 8 ? $width / 8 : 0}] burstcount Output $counts
        "
    }
    foreach {name end into against there} "
        in end Input Output [expr {!$reads}] out start Output Input [expr {!$writes}]
    " {
        if {!$there} { continue }
        interface $name avalon_streaming $end "
            valid $into 1 ready $against 1 data $into $width startofpacket $into 1
            endofpacket $into 1 empty $into $empty error $into $error
        "
        set_interface_property $name dataBitsPerSymbol 8
    }
}
