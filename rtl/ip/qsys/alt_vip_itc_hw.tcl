set_module_property NAME alt_vip_itc
set_module_property ELABORATION_CALLBACK elaborate
foreach {name value} {
    H_ACTIVE_PIXELS 1920 V_ACTIVE_LINES 1200 H_FRONT_PORCH 88 H_SYNC_LENGTH 44 H_BACK_PORCH 148
    V_FRONT_PORCH 4 V_SYNC_LENGTH 5 V_BACK_PORCH 36 FIFO_DEPTH 1920 THRESHOLD 1919
    CLOCKS_ARE_SAME 0 BITS 24
} {
    add_parameter $name INTEGER $value
    set_parameter_property $name HDL_PARAMETER true
}
foreach {name value} {
    BPS 8 NUMBER_OF_COLOUR_PLANES 3 COLOUR_PLANES_ARE_IN_PARALLEL 1 INTERLACED 0
    USE_EMBEDDED_SYNCS 0 USE_CONTROL 0 GENERATE_SYNC 0 ACCEPT_COLOURS_IN_SEQ 0 NO_OF_MODES 1
    STD_WIDTH 1 AP_LINE 0 V_BLANK 0 H_BLANK 0 ANC_LINE 0 F_RISING_EDGE 0 F_FALLING_EDGE 0
    FIELD0_V_RISING_EDGE 0 FIELD0_V_BLANK 0 FIELD0_V_SYNC_LENGTH 0 FIELD0_V_FRONT_PORCH 0
    FIELD0_V_BACK_PORCH 0 FIELD0_ANC_LINE 0
} { add_parameter $name INTEGER $value }
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL alt_vip_itc

add_interface is_clk_rst clock end
add_interface_port is_clk_rst is_clk clk Input 1
add_interface is_clk_rst_reset reset end
set_interface_property is_clk_rst_reset associatedClock is_clk_rst
add_interface_port is_clk_rst_reset rst reset Input 1
add_interface din avalon_streaming end
set_interface_property din associatedClock is_clk_rst
set_interface_property din readyLatency 1
set_interface_property din associatedReset is_clk_rst_reset
add_interface clocked_video conduit end

proc elaborate {} {
    foreach {name value what} {
        USE_CONTROL 0 "the control port"            USE_EMBEDDED_SYNCS 0 "embedded syncs"
        INTERLACED 0 "interlaced video"             COLOUR_PLANES_ARE_IN_PARALLEL 1 "planes in sequence"
    } {
        if {[get_parameter_value $name] != $value} {
            send_message error "$what of the clocked video output are not simulated"
        }
    }
    set bits [expr {[get_parameter_value BPS] * [get_parameter_value NUMBER_OF_COLOUR_PLANES]}]
    set_parameter_value BITS $bits
    foreach {name role direction count} "
        is_data data Input $bits     is_valid valid Input 1   is_ready ready Output 1
        is_sop startofpacket Input 1 is_eop endofpacket Input 1
    " { add_interface_port din $name $role $direction $count }
    if {![get_parameter_value CLOCKS_ARE_SAME]} {
        add_interface_port clocked_video vid_clk vid_clk Input 1
    }
    foreach {name count} "
        vid_data $bits underflow 1 vid_datavalid 1 vid_v_sync 1 vid_h_sync 1 vid_f 1 vid_h 1 vid_v 1
    " { add_interface_port clocked_video $name $name Output $count }
}
