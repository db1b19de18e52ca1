set_module_property NAME altpll
set_module_property ELABORATION_CALLBACK elaborate
add_parameter INCLK0_INPUT_FREQUENCY STRING 20000
foreach name {PORT_ARESET PORT_LOCKED PORT_PHASEDONE} { add_parameter $name STRING PORT_UNUSED }
for {set n 0} {$n < 10} {incr n} {
    add_parameter PORT_clk$n STRING PORT_UNUSED
    foreach name {MULTIPLY_BY DIVIDE_BY PHASE_SHIFT DUTY_CYCLE} {
        add_parameter CLK${n}_$name STRING ""
    }
}
for {set n 0} {$n < 5} {incr n} {
    add_parameter output_clock_frequency$n STRING "0 MHz"
    add_parameter phase_shift$n STRING "0 ps"
    set_parameter_property output_clock_frequency$n HDL_PARAMETER true
    set_parameter_property phase_shift$n HDL_PARAMETER true
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_altpll

add_interface inclk_interface clock end
add_interface_port inclk_interface clk clk Input 1
add_interface inclk_interface_reset reset end
set_interface_property inclk_interface_reset associatedClock inclk_interface
add_interface_port inclk_interface_reset reset reset Input 1
add_interface pll_slave avalon end
set_interface_property pll_slave associatedClock inclk_interface
set_interface_property pll_slave associatedReset inclk_interface_reset
foreach {name direction bits} {
    read Input 1 write Input 1 address Input 2 writedata Input 32 readdata Output 32
} { add_interface_port pll_slave $name $name $direction $bits }

proc is_used {name} { return [expr {[get_parameter_value $name] eq "PORT_USED"}] }

proc elaborate {} {
    set period [get_parameter_value INCLK0_INPUT_FREQUENCY]
    for {set n 0} {$n < 10} {incr n} {
        if {![is_used PORT_clk$n]} continue
        if {$n > 4} { send_message error "a clock c$n, expected c0 to c4" }
        set duty [get_parameter_value CLK${n}_DUTY_CYCLE]
        if {$duty ne "" && $duty != 50} {
            send_message error "c$n has a duty cycle of $duty %, expected 50"
        }
        set multiply [get_parameter_value CLK${n}_MULTIPLY_BY]
        set divide [get_parameter_value CLK${n}_DIVIDE_BY]
        if {![string is integer -strict $multiply] || ![string is integer -strict $divide]} {
            send_message error "c$n is multiplied by \"$multiply\" and divided by \"$divide\""
        }
        set ps [expr {double($period) * $divide / $multiply}]
        set shift [get_parameter_value CLK${n}_PHASE_SHIFT]
        if {$shift eq ""} { set shift 0 }
        set shift [expr {$shift - floor($shift / $ps) * $ps}]
        set_parameter_value output_clock_frequency$n "[expr {1e6 / $ps}] MHz"
        set_parameter_value phase_shift$n "[expr {round($shift)}] ps"
        add_interface c$n clock start
        add_interface_port c$n c$n clk Output 1
    }
    foreach {name port direction} {
        PORT_ARESET areset Input PORT_LOCKED locked Output PORT_PHASEDONE phasedone Output
    } {
        if {![is_used $name]} continue
        add_interface ${port}_conduit conduit end
        add_interface_port ${port}_conduit $port export $direction 1
    }
}
