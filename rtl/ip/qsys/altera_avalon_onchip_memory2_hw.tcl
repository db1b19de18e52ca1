set_module_property NAME altera_avalon_onchip_memory2
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value hdl} {
    dataWidth INTEGER 32 true             memorySize LONG 4096 true
    writable BOOLEAN true true            initMemContent BOOLEAN true false
    useNonDefaultInitFile BOOLEAN false false
    initializationFileName STRING onchip_mem.hex false
    autoInitializationFileName STRING "" false
    dualPort BOOLEAN false false          dataWidth2 INTEGER 32 false
    slave1Latency INTEGER 1 true          slave2Latency INTEGER 1 true
    singleClockOperation BOOLEAN false true
    init_file STRING UNUSED true
} {
    add_parameter $name $type $value
    set_parameter_property $name HDL_PARAMETER $hdl
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_avalon_onchip_memory2
set_module_assignment embeddedsw.dts.vendor altr
set_module_assignment embeddedsw.dts.name onchipmem
set_module_assignment embeddedsw.dts.group flash

add_interface clk1 clock end
add_interface_port clk1 clk clk Input 1
add_interface reset1 reset end
set_interface_property reset1 associatedClock clk1
add_interface_port reset1 reset reset Input 1
add_interface_port reset1 reset_req reset_req Input 1

proc port {number suffix} {
    set width [get_parameter_value dataWidth]
    set words [expr {[get_parameter_value memorySize] * 8 / $width}]
    set bits 0
    while {1 << $bits < $words} { incr bits }
    set s s$number
    add_interface $s avalon end
    foreach {property value} "
        associatedClock clk$number associatedReset reset$number
        readLatency [get_parameter_value slave${number}Latency] readWaitTime 0
        explicitAddressSpan [get_parameter_value memorySize]
    " { set_interface_property $s $property $value }
    add_interface_port $s address$suffix address Input [expr {$bits > 0 ? $bits : 1}]
    add_interface_port $s clken$suffix clken Input 1
    add_interface_port $s chipselect$suffix chipselect Input 1
    add_interface_port $s write$suffix write Input 1
    add_interface_port $s readdata$suffix readdata Output $width
    add_interface_port $s writedata$suffix writedata Input $width
    if {[string is false [get_parameter_value writable]]} {
        add_interface_port $s debugaccess$suffix debugaccess Input 1
    }
    if {$width > 8} { add_interface_port $s byteenable$suffix byteenable Input [expr {$width / 8}] }
}

proc elaborate {} {
    port 1 ""
    if {[string is true [get_parameter_value dualPort]]} {
        if {[string is true [get_parameter_value singleClockOperation]]} {
            # The second port is on the first one's clock.
            port 2 2
            set_interface_property s2 associatedClock clk1
            set_interface_property s2 associatedReset reset1
        } else {
            add_interface clk2 clock end
            add_interface_port clk2 clk2 clk Input 1
            add_interface reset2 reset end
            set_interface_property reset2 associatedClock clk2
            add_interface_port reset2 reset2 reset Input 1
            add_interface_port reset2 reset_req2 reset_req Input 1
            port 2 2
        }
    }
    if {[string is true [get_parameter_value initMemContent]]} {
        if {[string is true [get_parameter_value useNonDefaultInitFile]]} {
            set_parameter_value init_file [get_parameter_value initializationFileName]
        } else {
            # Platform Designer makes this file, of zeros, where there is none.
            set_parameter_value init_file [get_parameter_value autoInitializationFileName].hex?
        }
    }
}
