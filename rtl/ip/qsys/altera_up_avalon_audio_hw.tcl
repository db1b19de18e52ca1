set_module_property NAME altera_up_avalon_audio
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value hdl} {
    avalon_bus_type STRING {Memory Mapped} false
    audio_in BOOLEAN true true
    audio_out BOOLEAN true true
    dw INTEGER 32 true
    is_mapped BOOLEAN true true
} {
    add_parameter $name $type $value
    set_parameter_property $name HDL_PARAMETER $hdl
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_up_avalon_audio

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface external_interface conduit end

proc elaborate {} {
    set in [string is true [get_parameter_value audio_in]]
    set out [string is true [get_parameter_value audio_out]]
    set width [get_parameter_value dw]
    set mapped [expr {[get_parameter_value avalon_bus_type] ne "Streaming"}]
    set_parameter_value is_mapped [expr {$mapped ? "true" : "false"}]

    if {$in} {
        add_interface_port external_interface AUD_ADCDAT ADCDAT Input 1
        add_interface_port external_interface AUD_ADCLRCK ADCLRCK Input 1
    }
    add_interface_port external_interface AUD_BCLK BCLK Input 1
    if {$out} {
        add_interface_port external_interface AUD_DACDAT DACDAT Output 1
        add_interface_port external_interface AUD_DACLRCK DACLRCK Input 1
    }
    if {$mapped} {
        add_interface avalon_audio_slave avalon end
        foreach {property value} {
            associatedClock clk associatedReset reset readWaitTime 0 readLatency 1
        } { set_interface_property avalon_audio_slave $property $value }
        foreach {name direction bits} {
            address Input 2 chipselect Input 1 read Input 1 write Input 1 writedata Input 32
            readdata Output 32
        } { add_interface_port avalon_audio_slave $name $name $direction $bits }
        add_interface interrupt interrupt end
        set_interface_property interrupt associatedAddressablePoint avalon_audio_slave
        add_interface_port interrupt irq irq Output 1
        return
    }
    foreach side {left right} {
        if {$in} { stream avalon_${side}_channel_source start from_adc_${side}_channel $width }
        if {$out} { stream avalon_${side}_channel_sink end to_dac_${side}_channel $width }
    }
}

proc stream {name end port width} {
    set source [expr {$end eq "start"}]
    add_interface $name avalon_streaming $end
    set_interface_property $name associatedClock clk
    set_interface_property $name associatedReset reset
    set into [expr {$source ? "Input" : "Output"}]
    set out [expr {$source ? "Output" : "Input"}]
    add_interface_port $name ${port}_data data $out $width
    add_interface_port $name ${port}_valid valid $out 1
    add_interface_port $name ${port}_ready ready $into 1
}
