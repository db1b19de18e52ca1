set_module_property NAME altera_up_avalon_video_clipper
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value} {
    width_in 720    height_in 244    drop_left 0   drop_right 0   drop_top 0   drop_bottom 0
    add_left 0      add_right 0      add_top 0     add_bottom 0   color_bits 16   color_planes 1
    add_value_plane_1 0   add_value_plane_2 0   add_value_plane_3 0   add_value_plane_4 0
} { add_parameter $name INTEGER $value }
foreach {name value} {
    BITS 16        WIDTH 720     HEIGHT 244    DROP_LEFT 0   DROP_RIGHT 0   DROP_TOP 0
    DROP_BOTTOM 0  ADD_LEFT 0    ADD_RIGHT 0   ADD_TOP 0     ADD_BOTTOM 0
} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
add_parameter VALUE LONG 0
set_parameter_property VALUE HDL_PARAMETER true
set_parameter_property VALUE WIDTH 40
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL de1sim_up_clipper

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface avalon_clipper_sink avalon_streaming end
add_interface avalon_clipper_source avalon_streaming start
foreach name {avalon_clipper_sink avalon_clipper_source} {
    set_interface_property $name associatedClock clk
    set_interface_property $name associatedReset reset
}

proc elaborate {} {
    set plane [get_parameter_value color_bits]
    set planes [get_parameter_value color_planes]
    set bits [expr {$plane * $planes}]
    set value 0
    for {set n $planes} {$n > 0} {incr n -1} {
        set value [expr {$value << $plane | [get_parameter_value add_value_plane_$n]}]
    }
    set_parameter_value BITS $bits
    set_parameter_value VALUE $value
    set_parameter_value WIDTH [get_parameter_value width_in]
    set_parameter_value HEIGHT [get_parameter_value height_in]
    foreach name {
        drop_left drop_right drop_top drop_bottom add_left add_right add_top add_bottom
    } { set_parameter_value [string toupper $name] [get_parameter_value $name] }
    foreach {size before after} {
        width_in drop_left drop_right height_in drop_top drop_bottom
    } {
        if {[get_parameter_value $before] + [get_parameter_value $after]
                >= [get_parameter_value $size]} {
            send_message error "$before and $after leave nothing of $size,\
                [get_parameter_value $size]"
        }
    }
    foreach {interface port into against} {
        avalon_clipper_sink stream_in Input Output avalon_clipper_source stream_out Output Input
    } {
        foreach {role direction count} "
            data $into $bits startofpacket $into 1 endofpacket $into 1 valid $into 1
            ready $against 1
        " { add_interface_port $interface ${port}_$role $role $direction $count }
    }
}
