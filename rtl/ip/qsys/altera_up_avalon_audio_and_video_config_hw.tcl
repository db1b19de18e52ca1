set_module_property NAME altera_up_avalon_audio_and_video_config
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    device STRING {On-Board Peripherals}  board STRING DE1-SoC
    eai BOOLEAN true                      audio_in STRING {Line In to ADC}
    dac_enable BOOLEAN true               mic_bypass BOOLEAN false
    line_in_bypass BOOLEAN false          mic_attenuation STRING -6dB
    data_format STRING {Left Justified}   bit_length INTEGER 32
    sampling_rate STRING {48 kHz}         AUTO_CLK_CLOCK_RATE LONG 50000000
} { add_parameter $name $type $value }
foreach {name value} {SETS_UP 1 ANALOG 0 FORMAT 0 SAMPLING 0 QUARTER 125} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_up_avalon_audio_and_video_config

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_av_config_slave avalon end
set_interface_property avalon_av_config_slave associatedClock clk
set_interface_property avalon_av_config_slave associatedReset reset
foreach {name direction bits} {
    address Input 2 byteenable Input 4 read Input 1 write Input 1 writedata Input 32
    readdata Output 32 waitrequest Output 1
} { add_interface_port avalon_av_config_slave $name $name $direction $bits }
add_interface external_interface conduit end
add_interface_port external_interface I2C_SDAT SDAT Bidir 1
add_interface_port external_interface I2C_SCLK SCLK Output 1

# What is named in `table`, by its first word.
proc chosen {name table} {
    set value [lindex [get_parameter_value $name] 0]
    if {[dict exists $table $value]} { return [dict get $table $value] }
    send_message error "$name is \"[get_parameter_value $name]\", expected [join [dict keys $table]]"
}

proc elaborate {} {
    set rate [get_parameter_value AUTO_CLK_CLOCK_RATE]
    if {$rate > 0} { set_parameter_value QUARTER [expr {max(2, int(ceil($rate / 4e5)))}] }
    set on_board [string match -nocase On-Board* [get_parameter_value device]]
    set_parameter_value SETS_UP \
        [expr {$on_board && [string is true [get_parameter_value eai]] ? 1 : 0}]
    if {!$on_board} { return }
    set mic [string match -nocase Mic* [get_parameter_value audio_in]]
    set flag [list]
    foreach name {mic_bypass dac_enable line_in_bypass} {
        lappend flag [string is true [get_parameter_value $name]]
    }
    lassign $flag sidetone dac bypass
    set attenuation [chosen mic_attenuation {-6dB 0 -9dB 1 -12dB 2 -15dB 3}]
    set_parameter_value ANALOG [expr {($attenuation << 6) | ($sidetone << 5) | ($dac << 4)
                                      | ($bypass << 3) | ($mic << 2) | (!$mic << 1) | $mic}]
    # Bus master; the format; the bits of a sample.
    set_parameter_value FORMAT [expr {0x40 | [chosen data_format {Right 0 Left 1 I2S 2 DSP 3}]
                                      | ([chosen bit_length {16 0 20 1 24 2 32 3}] << 2)}]
    set_parameter_value SAMPLING \
        [chosen sampling_rate {8 0x0C 32 0x18 44.1 0x20 48 0x00 88.2 0x3C 96 0x1C}]
}
