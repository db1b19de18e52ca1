// sld_virtual_jtag_basic.v - as sld_virtual_jtag, for a node of a kind of its own

`default_nettype none

module sld_virtual_jtag_basic #(
    parameter sld_ir_width = 1, SLD_IR_WIDTH = sld_ir_width,
    // Without meaning here.
    parameter sld_mfg_id = 0, SLD_MFG_ID = sld_mfg_id,
    parameter sld_type_id = 0, SLD_TYPE_ID = sld_type_id,
    parameter sld_version = 0, SLD_VERSION = sld_version,
    parameter sld_auto_instance_index = "YES", SLD_AUTO_INSTANCE_INDEX = sld_auto_instance_index,
    parameter sld_instance_index = 0, SLD_INSTANCE_INDEX = sld_instance_index,
    parameter sld_sim_action = "UNUSED", SLD_SIM_ACTION = sld_sim_action,
    parameter sld_sim_n_scan = 0, SLD_SIM_N_SCAN = sld_sim_n_scan,
    parameter sld_sim_total_length = 0, SLD_SIM_TOTAL_LENGTH = sld_sim_total_length,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "sld_virtual_jtag_basic", LPM_TYPE = lpm_type,
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
    sld_virtual_jtag #(.SLD_IR_WIDTH(SLD_IR_WIDTH)) inert (
        .tdo(tdo), .ir_out(ir_out), .tck(tck), .tdi(tdi), .tms(tms), .ir_in(ir_in),
        .virtual_state_cdr(virtual_state_cdr), .virtual_state_sdr(virtual_state_sdr),
        .virtual_state_e1dr(virtual_state_e1dr), .virtual_state_pdr(virtual_state_pdr),
        .virtual_state_e2dr(virtual_state_e2dr), .virtual_state_udr(virtual_state_udr),
        .virtual_state_cir(virtual_state_cir), .virtual_state_uir(virtual_state_uir),
        .jtag_state_tlr(jtag_state_tlr), .jtag_state_rti(jtag_state_rti),
        .jtag_state_sdrs(jtag_state_sdrs), .jtag_state_cdr(jtag_state_cdr),
        .jtag_state_sdr(jtag_state_sdr), .jtag_state_e1dr(jtag_state_e1dr),
        .jtag_state_pdr(jtag_state_pdr), .jtag_state_e2dr(jtag_state_e2dr),
        .jtag_state_udr(jtag_state_udr), .jtag_state_sirs(jtag_state_sirs),
        .jtag_state_cir(jtag_state_cir), .jtag_state_sir(jtag_state_sir),
        .jtag_state_e1ir(jtag_state_e1ir), .jtag_state_pir(jtag_state_pir),
        .jtag_state_e2ir(jtag_state_e2ir), .jtag_state_uir(jtag_state_uir)
    );
endmodule

`default_nettype wire
