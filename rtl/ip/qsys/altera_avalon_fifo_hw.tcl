set_module_property NAME altera_avalon_fifo
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    avalonMMAvalonMMDataWidth INTEGER 32   avalonMMAvalonSTDataWidth INTEGER 32
    bitsPerSymbol INTEGER 16               symbolsPerBeat INTEGER 2
    channelWidth INTEGER 8                 errorWidth INTEGER 8
    fifoDepth INTEGER 16                   fifoInputInterfaceOptions STRING AVALONMM_WRITE
    showHiddenFeatures BOOLEAN false       fifoOutputInterfaceOptions STRING AVALONMM_READ
    singleClockMode BOOLEAN true           singleResetMode BOOLEAN false
    useBackpressure BOOLEAN true           useIRQ BOOLEAN true
    usePacket BOOLEAN true                 useRegister BOOLEAN false
    useReadControl BOOLEAN true            useWriteControl BOOLEAN true
} { add_parameter $name $type $value }
foreach {name value} {WIDTH 32 LOG2 4 DUAL 0 RESETS 2 SINK 0 SOURCE 0 SYMBOL 8 WAITS 1 EAB 1 EMPTY 1
                      CHANNEL 1 ERROR 1} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_fifo
set_module_assignment embeddedsw.dts.vendor ALTR
set_module_assignment embeddedsw.dts.name fifo
set_module_assignment embeddedsw.dts.group fifo
set_module_assignment embeddedsw.dts.compatible {ALTR,fifo-1.0}

proc on {name} { string is true [get_parameter_value $name] }

proc end_of {name type end side} {
    add_interface $name $type $end
    set_interface_property $name associatedClock clk_$side
    set_interface_property $name associatedReset \
        reset_[expr {[on singleResetMode] ? "in" : $side}]
}

proc control {side prefix} {
    end_of ${side}_csr avalon end $side
    set_interface_property ${side}_csr readWaitTime 0
    set_interface_property ${side}_csr readLatency 1
    foreach {role direction bits} {
        address Input 3 read Input 1 write Input 1 writedata Input 32 readdata Output 32
    } { add_interface_port ${side}_csr ${prefix}_control_slave_$role $role $direction $bits }
    if {![on useIRQ]} { return }
    end_of ${side}_irq interrupt end $side
    set_interface_property ${side}_irq associatedAddressablePoint ${side}_csr
    add_interface_port ${side}_irq ${prefix}_control_slave_irq irq Output 1
}

proc stream {name port into against symbol width empty channel error} {
    set packets [on usePacket]
    foreach {property value} [list dataBitsPerSymbol $symbol maxChannel [expr {(1 << $channel) - 1}] \
                                  readyLatency [on useBackpressure]] {
        set_interface_property $name $property $value
    }
    foreach {role bits} "
        valid 1 data $width startofpacket $packets endofpacket $packets
        empty [expr {$packets ? $empty : 0}] channel $channel error $error
    " { if {$bits > 0} { add_interface_port $name ${port}_$role $role $into $bits } }
    if {[on useBackpressure]} { add_interface_port $name ${port}_ready ready $against 1 }
}

proc elaborate {} {
    set sink [expr {[get_parameter_value fifoInputInterfaceOptions] eq "AVALONST_SINK"}]
    set source [expr {[get_parameter_value fifoOutputInterfaceOptions] eq "AVALONST_SOURCE"}]
    set depth [get_parameter_value fifoDepth]
    if {$depth < 8 || $depth & ($depth - 1)} {
        send_message error "fifoDepth is $depth, expected a power of two from 8 on"
    }
    set symbol [get_parameter_value bitsPerSymbol]
    set width [expr {$sink || $source ? $symbol * [get_parameter_value symbolsPerBeat]
                     : [get_parameter_value avalonMMAvalonMMDataWidth]}]
    set dual [expr {![on singleClockMode]}]
    foreach {name parameter} {channel channelWidth error errorWidth} {
        set $name [get_parameter_value $parameter]
        if {[set $name] < 0 || [set $name] > 8} {
            send_message error "$parameter is [set $name], expected 0 to 8"
        }
    }
    set symbols [get_parameter_value symbolsPerBeat]
    for {set empty 0} {1 << $empty < $symbols} {incr empty} {}
    if {$empty > 5} { send_message error "symbolsPerBeat is $symbols, expected at most 32" }
    for {set log2 3} {1 << $log2 < $depth} {incr log2} {}
    foreach {name value} [list WIDTH $width LOG2 $log2 DUAL $dual \
                              RESETS [expr {2 - [on singleResetMode]}] SINK $sink SOURCE $source \
                              SYMBOL $symbol WAITS [on useBackpressure] EAB [expr {![on useRegister]}] \
                              EMPTY [expr {max($empty, 1)}] CHANNEL [expr {max($channel, 1)}] \
                              ERROR [expr {max($error, 1)}]] { set_parameter_value $name $value }

    foreach {side prefix} [expr {$dual ? "in wr out rd" : "in wr"}] {
        add_interface clk_$side clock end
        add_interface_port clk_$side ${prefix}clock clk Input 1
        if {$side eq "out" && [on singleResetMode]} { continue }
        add_interface reset_$side reset end
        set_interface_property reset_$side associatedClock clk_$side
        add_interface_port reset_$side ${prefix}reset_n reset_n Input 1
    }
    set out [expr {$dual ? "out" : "in"}]
    if {$sink} {
        end_of in avalon_streaming end in
        stream in avalonst_sink Input Output $symbol $width $empty $channel $error
    } else {
        end_of in avalon end in
        if {$source} { add_interface_port in avalonmm_write_slave_address address Input 1 }
        add_interface_port in avalonmm_write_slave_write write Input 1
        add_interface_port in avalonmm_write_slave_writedata writedata Input $width
        if {[on useBackpressure]} {
            add_interface_port in avalonmm_write_slave_waitrequest waitrequest Output 1
        }
    }
    if {$source} {
        end_of out avalon_streaming start $out
        stream out avalonst_source Output Input $symbol $width $empty $channel $error
    } else {
        end_of out avalon end $out
        if {$sink} { add_interface_port out avalonmm_read_slave_address address Input 1 }
        set_interface_property out readWaitTime 0
        set_interface_property out readLatency 1
        add_interface_port out avalonmm_read_slave_read read Input 1
        add_interface_port out avalonmm_read_slave_readdata readdata Output $width
        if {[on useBackpressure]} {
            add_interface_port out avalonmm_read_slave_waitrequest waitrequest Output 1
        }
    }
    if {[on useWriteControl]} { control in wrclk }
    if {$dual && [on useReadControl]} { control out rdclk }
}
