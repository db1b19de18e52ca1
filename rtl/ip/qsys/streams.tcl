# streams.tcl - what the descriptions of components with Avalon streams share

proc value {name} { get_parameter_value $name }
proc on {name} { string is true [value $name] }

# How many bits a number below `count` has.
proc bits_below {count} {
    for {set bits 0} {1 << $bits < $count} {incr bits} {}
    return $bits
}

# Integers that are parameters of the Verilog.
proc hdl_parameters {values} {
    foreach {name value} $values {
        add_parameter $name INTEGER $value
        set_parameter_property $name HDL_PARAMETER true
    }
}

# Interfaces of a clock and its reset; a reset's port is active low if its name ends in _n.
proc clock_and_reset {clock clock_port reset reset_port} {
    add_interface $clock clock end
    add_interface_port $clock $clock_port clk Input 1
    add_interface $reset reset end
    set_interface_property $reset associatedClock $clock
    add_interface_port $reset $reset_port \
        [expr {[string match *_n $reset_port] ? "reset_n" : "reset"}] Input 1
}

# A sink (`end`) or a source (`start`), with its clock and reset.  Its ports are PREFIX_ROLE;
# `signals` are roles with their bits, of which 0 are none.
proc stream {name prefix end clock reset properties signals} {
    add_interface $name avalon_streaming $end
    foreach {property value} [list associatedClock $clock associatedReset $reset {*}$properties] {
        set_interface_property $name $property $value
    }
    foreach {role bits} $signals {
        if {$bits <= 0} { continue }
        set direction [expr {($role eq "ready") == ($end eq "end") ? "Output" : "Input"}]
        add_interface_port $name ${prefix}_$role $role $direction $bits
    }
}
