set_module_property NAME altera_tristate_conduit_bridge
set_module_property ELABORATION_CALLBACK elaborate
add_parameter INTERFACE_INFO STRING ""
for {set n 0} {$n < 16} {incr n} {
    add_parameter W$n INTEGER 1
    set_parameter_property W$n HDL_PARAMETER true
}
add_parameter DATA INTEGER 16
set_parameter_property DATA HDL_PARAMETER true
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_tristate_conduit_bridge

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clk
add_interface_port reset reset reset Input 1
add_interface tcs tristate_conduit end
add_interface_port tcs request request Input 1
add_interface_port tcs grant grant Output 1
add_interface out conduit end

# The pins are those of INTERFACE_INFO: <pin role= width= type= output_name= ... input_name= />.
proc elaborate {} {
    set count 0
    foreach pin [regexp -all -inline {<pin [^>]*>} [get_parameter_value INTERFACE_INFO]] {
        foreach key {role width type output_name input_name} {
            set $key ""
            regexp "\[ \]$key=\"(\[^\"\]*)\"" $pin -> $key
        }
        switch $type {
            Invalid { }
            Output {
                if {$count == 16} {
                    send_message error "INTERFACE_INFO has more than 16 outputs"
                    return
                }
                set_parameter_value W$count $width
                add_interface_port tcs p${count}_i ${role}_out Input $width
                add_interface_port out p${count}_o $output_name Output $width
                incr count
            }
            Bidirectional {
                if {$role ne "data"} {
                    send_message error "the pin $role is bidirectional, expected data alone"
                }
                set_parameter_value DATA $width
                add_interface_port tcs data_out data_out Input $width
                add_interface_port tcs data_outen data_outen Input 1
                add_interface_port tcs data_in data_in Output $width
                add_interface_port out data_io $output_name Bidir $width
                if {$width > 1} { set_port_property data_io VHDL_TYPE STD_LOGIC_VECTOR }
            }
            Input {
                if {$role ne "waitrequest"} {
                    send_message error "the pin $role is an input, expected waitrequest alone"
                }
                add_interface_port tcs wait_o waitrequest_in Output 1
                add_interface_port out wait_i $input_name Input 1
            }
            default { send_message error "the pin $role is of the type $type, expected Output,\
                                          Bidirectional or Input" }
        }
    }
}
