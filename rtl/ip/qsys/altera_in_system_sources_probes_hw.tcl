set_module_property NAME altera_in_system_sources_probes
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value hdl} {
    create_source_clock BOOLEAN false false    create_source_clock_enable BOOLEAN false false
    instance_id STRING NONE true               source_initial_value STRING 0 true
    probe_width INTEGER 1 true                 source_width INTEGER 1 true
} {
    add_parameter $name $type $value
    set_parameter_property $name HDL_PARAMETER $hdl
}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altsource_probe

proc elaborate {} {
    foreach {name port direction} {sources source Output probes probe Input} {
        set width [get_parameter_value ${port}_width]
        if {$width < 0 || $width > 512} {
            send_message error "${port}_width is $width, expected 0 to 512"
        }
        if {$width > 0} {
            add_interface $name conduit end
            add_interface_port $name $port $port $direction $width
            set_port_property $port VHDL_TYPE STD_LOGIC_VECTOR
        }
    }
    if {[string is true [get_parameter_value create_source_clock]]} {
        add_interface source_clk clock end
        add_interface_port source_clk source_clk clk Input 1
        if {[string is true [get_parameter_value create_source_clock_enable]]} {
            add_interface source_ena conduit end
            add_interface_port source_ena source_ena source_ena Input 1
        }
    }
}
