// lpm_latch.v - latches: open while gate is 1

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module lpm_latch #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_avalue = "UNUSED", LPM_AVALUE = lpm_avalue,
    // Without meaning here.
    parameter lpm_pvalue = "UNUSED", LPM_PVALUE = lpm_pvalue,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_latch", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire [LPM_WIDTH-1:0] data,
    input  wire                 gate, aclr, aset,
    output wire [LPM_WIDTH-1:0] q
);
    `include "de1sim_number.vh"

    localparam [LPM_WIDTH-1:0] ONES   = {LPM_WIDTH{1'b1}};
    localparam [LPM_WIDTH-1:0] AVALUE = LPM_AVALUE == "UNUSED" ? ONES : de1sim_number(LPM_AVALUE);

    reg [LPM_WIDTH-1:0] q_q;
    // They are meant to be latches.
    // verilator lint_off LATCH
    always @*
        if (aclr) q_q = 0;
        else if (aset) q_q = AVALUE;
        else if (gate) q_q = data;
    // verilator lint_on LATCH
    assign q = q_q;
// verilator lint_on WIDTH
endmodule

`default_nettype wire
