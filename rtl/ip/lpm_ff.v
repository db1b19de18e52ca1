// lpm_ff.v - flip-flops of D or T kind
//
// Not handled: aload (Cyclone V has no such registers).

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module lpm_ff #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_fftype = "DFF", LPM_FFTYPE = lpm_fftype,
    parameter lpm_avalue = "UNUSED", LPM_AVALUE = lpm_avalue,
    parameter lpm_svalue = "UNUSED", LPM_SVALUE = lpm_svalue,
    // Without meaning here.
    parameter lpm_pvalue = "UNUSED", LPM_PVALUE = lpm_pvalue,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_ff", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                 clock, enable,
    input  wire                 aclr, aset, aload, sclr, sset, sload,
    input  wire [LPM_WIDTH-1:0] data,
    output wire [LPM_WIDTH-1:0] q
);
    `include "de1sim_number.vh"

    localparam [LPM_WIDTH-1:0] ONES   = {LPM_WIDTH{1'b1}};
    localparam [LPM_WIDTH-1:0] AVALUE = LPM_AVALUE == "UNUSED" ? ONES : de1sim_number(LPM_AVALUE);
    localparam [LPM_WIDTH-1:0] SVALUE = LPM_SVALUE == "UNUSED" ? ONES : de1sim_number(LPM_SVALUE);

    reg [LPM_WIDTH-1:0] q_q;
    always @(posedge clock or posedge aclr or posedge aset)
        if (aclr) q_q <= 0;
        else if (aset) q_q <= AVALUE;
        else if (enable) begin
            if (sclr) q_q <= 0;
            else if (sset) q_q <= SVALUE;
            else if (sload || LPM_FFTYPE != "TFF") q_q <= data;
            else q_q <= q_q ^ data;
        end

    assign q = q_q;
// verilator lint_on WIDTH
endmodule

`default_nettype wire
