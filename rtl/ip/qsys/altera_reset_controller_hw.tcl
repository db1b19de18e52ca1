set_module_property NAME altera_reset_controller
set_module_property ELABORATION_CALLBACK elaborate
foreach {name type value} {
    NUM_RESET_INPUTS INTEGER 6        OUTPUT_RESET_SYNC_EDGES STRING deassert  SYNC_DEPTH INTEGER 2
    RESET_REQUEST_PRESENT INTEGER 0   MIN_RST_ASSERTION_TIME INTEGER 3
    RESET_REQ_WAIT_TIME INTEGER 1     RESET_REQ_EARLY_DSRT_TIME INTEGER 1
} { add_parameter $name $type $value }
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL altera_reset_controller

add_interface clk clock end
add_interface_port clk clk clk Input 1
add_interface reset_out reset start
set_interface_property reset_out associatedClock clk
add_interface_port reset_out reset_out reset Output 1

proc elaborate {} {
    for {set n 0} {$n < [get_parameter_value NUM_RESET_INPUTS]} {incr n} {
        add_interface reset_in$n reset end
        set_interface_property reset_in$n synchronousEdges none
        add_interface_port reset_in$n reset_in$n reset Input 1
    }
    if {[get_parameter_value RESET_REQUEST_PRESENT]} {
        add_interface_port reset_out reset_req reset_req Output 1
    }
}
