set_module_property NAME altera_pll
set_module_property ELABORATION_CALLBACK elaborate
add_parameter gui_number_of_clocks INTEGER 1
add_parameter gui_use_locked BOOLEAN true
add_parameter gui_reference_clock_frequency FLOAT 100.0
add_parameter gui_en_reconf BOOLEAN false
add_parameter gui_pll_mode STRING "Integer-N PLL"
for {set n 0} {$n < 18} {incr n} {
    add_parameter gui_output_clock_frequency$n FLOAT 100.0
    add_parameter gui_phase_shift$n FLOAT 0
    add_parameter gui_phase_shift_deg$n FLOAT 0.0
    add_parameter gui_ps_units$n STRING ps
}
for {set n 0} {$n < 8} {incr n} {
    add_parameter output_clock_frequency$n STRING "0 MHz"
    add_parameter phase_shift$n STRING "0 ps"
    set_parameter_property output_clock_frequency$n HDL_PARAMETER true
    set_parameter_property phase_shift$n HDL_PARAMETER true
}
foreach {name value} {pll_subtype General reference "50.0 MHz" fractional false} {
    add_parameter $name STRING $value
    set_parameter_property $name HDL_PARAMETER true
}
foreach {name width} {K 32 M 18 N 18 C0 18 C1 18 C2 18 C3 18 C4 18 C5 18 C6 18 C7 18} {
    add_parameter $name STD_LOGIC_VECTOR 0
    set_parameter_property $name HDL_PARAMETER true
    set_parameter_property $name WIDTH $width
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_pll

add_interface refclk clock end
add_interface_port refclk refclk clk Input 1
add_interface reset reset end
add_interface_port reset rst reset Input 1

# Of a total: 7..0 low, 15..8 high, 16 bypass, 17 odd.
proc counter {total} {
    if {$total <= 1} { return 65536 }
    return [expr {($total % 2) << 17 | ($total + 1) / 2 << 8 | $total / 2}]
}

# The counters with which the PLL begins: the smallest N and M by which the VCO is at 300 to 1600
# MHz, and a whole multiple of each clock.
proc find_counters {reference clocks} {
    set fractional [string match "*ractional*" [get_parameter_value gui_pll_mode]]
    for {set n 1} {$n <= 16 && !$fractional} {incr n} {
        for {set m [expr {int(ceil(300.0 * $n / $reference))}]} {
            $m <= 512 && $reference * $m / $n <= 1600
        } {incr m} {
            set fits 1
            foreach mhz $clocks {
                set c [expr {$reference * $m / $n / $mhz}]
                if {abs($c - round($c)) > 1e-5 * $c || round($c) > 512} { set fits 0 }
            }
            if {$fits} { return [list $n $m 0] }
        }
    }
    set vco [expr {ceil(300.0 / [lindex $clocks 0]) * [lindex $clocks 0]}]
    set m [expr {int(floor($vco / $reference))}]
    return [list 1 $m [expr {entier(($vco / $reference - $m) * 4294967296)}]]
}

proc reconfigure {clocks} {
    set reference [get_parameter_value gui_reference_clock_frequency]
    lassign [find_counters $reference $clocks] n m k
    set_parameter_value pll_subtype Reconfigurable
    set_parameter_value reference "$reference MHz"
    set_parameter_value fractional [expr {$k != 0 ? "true" : "false"}]
    foreach {name value} "N [counter $n] M [counter $m] K $k" { set_parameter_value $name $value }
    set vco [expr {$reference * ($m + $k / 4294967296.0) / $n}]
    set at 0
    foreach mhz $clocks {
        set_parameter_value C$at [counter [expr {int(round($vco / $mhz))}]]
        incr at
    }
    foreach {name direction} {reconfig_to_pll Input reconfig_from_pll Output} {
        add_interface $name conduit end
        add_interface_port $name $name $name $direction 64
    }
}

proc elaborate {} {
    set clocks {}
    set count [get_parameter_value gui_number_of_clocks]
    if {$count > 8} { send_message error "$count clocks, expected at most 8" }
    for {set n 0} {$n < $count} {incr n} {
        add_interface outclk$n clock start
        add_interface_port outclk$n outclk_$n clk Output 1
        set mhz [get_parameter_value gui_output_clock_frequency$n]
        set_parameter_value output_clock_frequency$n "$mhz MHz"
        lappend clocks $mhz
        set ps [get_parameter_value gui_phase_shift$n]
        if {[get_parameter_value gui_ps_units$n] eq "degrees"} {
            set ps [expr {[get_parameter_value gui_phase_shift_deg$n] * 1e6 / $mhz / 360}]
        }
        set_parameter_value phase_shift$n "[expr {round($ps)}] ps"
    }
    if {[string is true [get_parameter_value gui_en_reconf]]} { reconfigure $clocks }
    if {[string is true [get_parameter_value gui_use_locked]]} {
        add_interface locked conduit end
        add_interface_port locked locked export Output 1
    }
}
