// lpm_shiftreg.v - a shift register with parallel load
//
// LEFT, the default, shifts from bit 0 up.  Of the inputs at one edge, sclr comes before sset, and
// load before a shift; aclr and aset act at once.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module lpm_shiftreg #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_direction = "LEFT", LPM_DIRECTION = lpm_direction,
    parameter lpm_avalue = "UNUSED", LPM_AVALUE = lpm_avalue,
    parameter lpm_svalue = "UNUSED", LPM_SVALUE = lpm_svalue,
    // Without meaning here.
    parameter lpm_pvalue = "UNUSED", LPM_PVALUE = lpm_pvalue,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_shiftreg", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                 clock, enable, load, shiftin,
    input  wire                 aclr, aset, sclr, sset,
    input  wire [LPM_WIDTH-1:0] data,
    output wire [LPM_WIDTH-1:0] q,
    output wire                 shiftout
);
    `include "de1sim_number.vh"

    localparam [LPM_WIDTH-1:0] ONES   = {LPM_WIDTH{1'b1}};
    localparam [LPM_WIDTH-1:0] AVALUE = LPM_AVALUE == "UNUSED" ? ONES : de1sim_number(LPM_AVALUE);
    localparam [LPM_WIDTH-1:0] SVALUE = LPM_SVALUE == "UNUSED" ? ONES : de1sim_number(LPM_SVALUE);
    localparam RIGHT = LPM_DIRECTION == "RIGHT";

    reg  [LPM_WIDTH-1:0] q_q;
    wire [LPM_WIDTH:0]   longer = RIGHT ? {shiftin, q_q} : {q_q, shiftin};
    always @(posedge clock or posedge aclr or posedge aset)
        if (aclr) q_q <= 0;
        else if (aset) q_q <= AVALUE;
        else if (enable) begin
            if (sclr) q_q <= 0;
            else if (sset) q_q <= SVALUE;
            else if (load) q_q <= data;
            else q_q <= RIGHT ? longer[LPM_WIDTH:1] : longer[LPM_WIDTH-1:0];
        end

    assign q = q_q;
    assign shiftout = RIGHT ? q_q[0] : q_q[LPM_WIDTH-1];
// verilator lint_on WIDTH
endmodule

`default_nettype wire
