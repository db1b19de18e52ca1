// sld_virtual_jtag.v - JTAG from a computer, of which there is none here: no clock, no state

`default_nettype none

module sld_virtual_jtag #(
    parameter sld_ir_width = 1, SLD_IR_WIDTH = sld_ir_width,
    // Without meaning here.
    parameter sld_auto_instance_index = "YES", SLD_AUTO_INSTANCE_INDEX = sld_auto_instance_index,
    parameter sld_instance_index = 0, SLD_INSTANCE_INDEX = sld_instance_index,
    parameter sld_sim_action = "UNUSED", SLD_SIM_ACTION = sld_sim_action,
    parameter sld_sim_n_scan = 0, SLD_SIM_N_SCAN = sld_sim_n_scan,
    parameter sld_sim_total_length = 0, SLD_SIM_TOTAL_LENGTH = sld_sim_total_length,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "sld_virtual_jtag", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                    tdo,
    input  wire [SLD_IR_WIDTH-1:0] ir_out,
    output wire                    tck, tdi, tms,
    output wire [SLD_IR_WIDTH-1:0] ir_in,
    output wire                    virtual_state_cdr, virtual_state_sdr, virtual_state_e1dr,
    output wire                    virtual_state_pdr, virtual_state_e2dr, virtual_state_udr,
    output wire                    virtual_state_cir, virtual_state_uir,
    output wire                    jtag_state_tlr, jtag_state_rti, jtag_state_sdrs,
    output wire                    jtag_state_cdr, jtag_state_sdr, jtag_state_e1dr,
    output wire                    jtag_state_pdr, jtag_state_e2dr, jtag_state_udr,
    output wire                    jtag_state_sirs, jtag_state_cir, jtag_state_sir,
    output wire                    jtag_state_e1ir, jtag_state_pir, jtag_state_e2ir,
    output wire                    jtag_state_uir
);
    assign {tck, tdi, tms} = 3'd0;
    assign ir_in = {SLD_IR_WIDTH{1'b0}};
    assign {virtual_state_cdr, virtual_state_sdr, virtual_state_e1dr, virtual_state_pdr,
            virtual_state_e2dr, virtual_state_udr, virtual_state_cir, virtual_state_uir} = 8'd0;
    assign jtag_state_tlr = 1'b1;
    assign {jtag_state_rti, jtag_state_sdrs, jtag_state_cdr, jtag_state_sdr, jtag_state_e1dr,
            jtag_state_pdr, jtag_state_e2dr, jtag_state_udr, jtag_state_sirs, jtag_state_cir,
            jtag_state_sir, jtag_state_e1ir, jtag_state_pir, jtag_state_e2ir,
            jtag_state_uir} = 15'd0;
endmodule

`default_nettype wire
