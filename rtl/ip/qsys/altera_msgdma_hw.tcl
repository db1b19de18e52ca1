set_module_property NAME altera_msgdma
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value} {
    USE_FIX_ADDRESS_WIDTH 0 FIX_ADDRESS_WIDTH 32 EXPOSE_ST_PORT 0 DATA_FIFO_DEPTH 32
    DESCRIPTOR_FIFO_DEPTH 128 RESPONSE_PORT 2 MAX_BYTE 1024 BURST_ENABLE 0 MAX_BURST_COUNT 2
    BURST_WRAPPING_SUPPORT 0 ENHANCED_FEATURES 0 STRIDE_ENABLE 0 MAX_STRIDE 1
    PROGRAMMABLE_BURST_ENABLE 0 PACKET_ENABLE 0 ERROR_ENABLE 0 CHANNEL_ENABLE 0
    PREFETCHER_ENABLE 0
} { add_parameter $name INTEGER $value }
add_parameter TRANSFER_TYPE STRING "Aligned Accesses"
foreach {name value} {
    MODE 0 DATA_WIDTH 32 FIFO_LOG2 5 DEPTH_LOG2 7 LENGTH 11 ENHANCED 0 BURST 1 WRAPS 0 PROGRAMS 0
    STRIDES 0 UNALIGNED 0 WHOLE 0 PACKETS 0 RESPONSES 2 EXPOSED 0 ERROR_WIDTH 8 CHANNEL_WIDTH 8
    COUNT_WIDTH 1 EMPTY_WIDTH 2
} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_msgdma
set_module_assignment embeddedsw.dts.vendor altr
set_module_assignment embeddedsw.dts.group msgdma
set_module_assignment embeddedsw.dts.name msgdma
set_module_assignment embeddedsw.dts.compatible altr,msgdma-1.0

add_interface clock clock end
add_interface_port clock clock clk Input 1
add_interface reset_n reset end
set_interface_property reset_n associatedClock clock
add_interface_port reset_n reset_n reset_n Input 1

proc value {name} { get_parameter_value $name }
proc fail {what} { send_message error $what }

proc log2 {number} {
    for {set bits 0} {1 << $bits < $number} {incr bits} {}
    return $bits
}

proc interface {name type end ports} {
    add_interface $name $type $end
    set_interface_property $name associatedClock clock
    set_interface_property $name associatedReset reset_n
    foreach {port role direction bits} $ports {
        if {$bits > 0} { add_interface_port $name $port $role $direction $bits }
    }
}

proc check {} {
    foreach {name allowed} {
        MODE {0 1 2}  DATA_WIDTH {8 16 32 64 128 256 512 1024}  RESPONSE_PORT {0 1 2}
        DATA_FIFO_DEPTH {16 32 64 128 256 512 1024 2048 4096}
        DESCRIPTOR_FIFO_DEPTH {8 16 32 64 128 256 512 1024}
        MAX_BURST_COUNT {2 4 8 16 32 64 128 256 512 1024}
        TRANSFER_TYPE {"Full Word Accesses Only" "Aligned Accesses" "Unaligned Accesses"}
    } {
        if {[value $name] ni $allowed} {
            fail "$name is [value $name], expected one of [join $allowed {, }]"
        }
    }
    if {[value PREFETCHER_ENABLE]} { fail "the prefetcher (PREFETCHER_ENABLE) cannot be simulated" }
    if {![value ENHANCED_FEATURES]} {
        set_parameter_value STRIDE_ENABLE 0
        set_parameter_value PROGRAMMABLE_BURST_ENABLE 0
    }
    if {![value BURST_ENABLE]} {
        foreach name {PROGRAMMABLE_BURST_ENABLE BURST_WRAPPING_SUPPORT} { set_parameter_value $name 0 }
    }
    if {[value STRIDE_ENABLE] && [value BURST_ENABLE]} {
        fail "STRIDE_ENABLE and BURST_ENABLE exclude each other"
    }
    if {[value STRIDE_ENABLE] && [value TRANSFER_TYPE] eq "Unaligned Accesses"} {
        fail "STRIDE_ENABLE and unaligned accesses exclude each other"
    }
    if {[value BURST_ENABLE] && [value MAX_BURST_COUNT] * 4 > [value DATA_FIFO_DEPTH]} {
        fail "DATA_FIFO_DEPTH is [value DATA_FIFO_DEPTH], expected at least four times\
            MAX_BURST_COUNT, [value MAX_BURST_COUNT]"
    }
    if {[value PROGRAMMABLE_BURST_ENABLE] && [value BURST_WRAPPING_SUPPORT]} {
        fail "PROGRAMMABLE_BURST_ENABLE and BURST_WRAPPING_SUPPORT exclude each other"
    }
}

proc elaborate {} {
    check
    set mode [value MODE]
    set width [value DATA_WIDTH]
    set bytes [expr {$width / 8}]
    set empty [expr {max([log2 $bytes], 1)}]
    set burst [expr {[value BURST_ENABLE] ? [value MAX_BURST_COUNT] : 1}]
    set count [expr {[log2 $burst] + 1}]
    set packets [expr {$mode != 0 && [value PACKET_ENABLE]}]
    set words [expr {[value ENHANCED_FEATURES] ? 8 : 4}]
    set type [value TRANSFER_TYPE]
    set whole [expr {$width == 8 || $type eq "Full Word Accesses Only"}]
    foreach {name value} [list \
        FIFO_LOG2 [log2 [value DATA_FIFO_DEPTH]] DEPTH_LOG2 [log2 [value DESCRIPTOR_FIFO_DEPTH]] \
        LENGTH [expr {min([log2 [value MAX_BYTE]] + 1, 32)}] ENHANCED [value ENHANCED_FEATURES] \
        BURST $burst WRAPS [value BURST_WRAPPING_SUPPORT] \
        PROGRAMS [value PROGRAMMABLE_BURST_ENABLE] STRIDES [value STRIDE_ENABLE] \
        UNALIGNED [expr {!$whole && $type eq "Unaligned Accesses"}] WHOLE $whole PACKETS $packets \
        RESPONSES [value RESPONSE_PORT] EXPOSED [value EXPOSE_ST_PORT] COUNT_WIDTH $count \
        EMPTY_WIDTH $empty] { set_parameter_value $name $value }

    interface csr avalon end {
        csr_address address Input 3 csr_read read Input 1 csr_write write Input 1
        csr_byteenable byteenable Input 4 csr_writedata writedata Input 32
        csr_readdata readdata Output 32
    }
    set_interface_property csr readLatency 1
    interface descriptor_slave avalon end "
        descriptor_write write Input 1 descriptor_byteenable byteenable Input [expr {4 * $words}]
        descriptor_writedata writedata Input [expr {32 * $words}]
        descriptor_waitrequest waitrequest Output 1
    "
    if {$mode != 1 && [value RESPONSE_PORT] == 0} {
        interface response avalon end {
            response_address address Input 1 response_read read Input 1
            response_byteenable byteenable Input 4 response_readdata readdata Output 32
            response_waitrequest waitrequest Output 1
        }
    }
    if {$mode != 1 && [value RESPONSE_PORT] == 1} {
        interface response avalon_streaming start {
            src_response_data data Output 256 src_response_valid valid Output 1
            src_response_ready ready Input 1
        }
        set_interface_property response dataBitsPerSymbol 256
    } else {
        interface csr_irq interrupt end {csr_irq irq Output 1}
        set_interface_property csr_irq associatedAddressablePoint csr
    }
    set lanes [expr {$width > 8 ? $bytes : 0}]
    set counts [expr {[value BURST_ENABLE] ? $count : 0}]
    if {$mode != 2} {
        interface mm_read avalon start "
            read_address address Output 32 read_read read Output 1
            read_byteenable byteenable Output $lanes read_burstcount burstcount Output $counts
            read_waitrequest waitrequest Input 1 read_readdatavalid readdatavalid Input 1
            read_readdata readdata Input $width
        "
    }
    if {$mode != 1} {
        interface mm_write avalon start "
            write_address address Output 32 write_write write Output 1
            write_byteenable byteenable Output $lanes write_burstcount burstcount Output $counts
            write_waitrequest waitrequest Input 1 write_writedata writedata Output $width
        "
    }
    set exposed [expr {$mode == 0 && [value EXPOSE_ST_PORT]}]
    foreach {name end port into against there} "
        st_source start src Output Input [expr {$mode == 1 || $exposed}]
        st_sink end snk Input Output [expr {$mode == 2 || $exposed}]
    " {
        if {!$there} { continue }
        set channel [expr {$mode == 1 && [value CHANNEL_ENABLE] ? [value CHANNEL_WIDTH] : 0}]
        interface $name avalon_streaming $end "
            ${port}_valid valid $into 1 ${port}_ready ready $against 1 ${port}_data data $into $width
            ${port}_startofpacket startofpacket $into $packets
            ${port}_endofpacket endofpacket $into $packets
            ${port}_empty empty $into [expr {$packets && $width > 8 ? $empty : 0}]
            ${port}_error error $into [expr {$mode != 0 && [value ERROR_ENABLE] ? [value ERROR_WIDTH] : 0}]
            ${port}_channel channel $into $channel
        "
        set_interface_property $name dataBitsPerSymbol 8
        set_interface_property $name maxChannel [expr {$channel ? (1 << $channel) - 1 : 0}]
    }
}
