// lpm_counter.v - up and down, with any modulus, and clears and loads of both kinds
//
// Of the inputs at one edge, sclr comes before sset, sload and counting; aclr and aset act at
// once.  sload and the clears need clk_en; cnt_en and cin are for counting alone.  cout is
// 1 at the last value before the counter begins again.
//
// Not handled: aload (Cyclone V has no such registers).

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module lpm_counter #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_modulus = 0, LPM_MODULUS = lpm_modulus,
    parameter lpm_direction = "UNUSED", LPM_DIRECTION = lpm_direction,
    parameter lpm_avalue = "UNUSED", LPM_AVALUE = lpm_avalue,
    parameter lpm_svalue = "UNUSED", LPM_SVALUE = lpm_svalue,
    // Without meaning here.
    parameter lpm_pvalue = "UNUSED", LPM_PVALUE = lpm_pvalue,
    parameter lpm_port_updown = "PORT_CONNECTIVITY", LPM_PORT_UPDOWN = lpm_port_updown,
    parameter width = 0, WIDTH = width,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_counter", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                 clock, clk_en, cnt_en, cin,
    input  wire                 updown,             // 1 is up
    input  wire                 aclr, aset, aload, sclr, sset, sload,
    input  wire [LPM_WIDTH-1:0] data,
    output wire [LPM_WIDTH-1:0] q,
    output wire                 cout,
    output wire [15:0]          eq
);
    `include "de1sim_number.vh"

    localparam [LPM_WIDTH-1:0] ONES   = {LPM_WIDTH{1'b1}};
    localparam [LPM_WIDTH-1:0] LAST   = LPM_MODULUS ? LPM_MODULUS - 1 : ONES;
    localparam [LPM_WIDTH-1:0] AVALUE =
        LPM_AVALUE == "UNUSED" ? ONES : de1sim_number(LPM_AVALUE);
    localparam [LPM_WIDTH-1:0] SVALUE =
        LPM_SVALUE == "UNUSED" ? ONES : de1sim_number(LPM_SVALUE);

    wire up = LPM_DIRECTION == "UP" || LPM_DIRECTION != "DOWN" && updown;
    wire at_end = q_q == (up ? LAST : {LPM_WIDTH{1'b0}});

    reg [LPM_WIDTH-1:0] q_q;
    always @(posedge clock or posedge aclr or posedge aset)
        if (aclr) q_q <= 0;
        else if (aset) q_q <= AVALUE;
        else if (clk_en) begin
            if (sclr) q_q <= 0;
            else if (sset) q_q <= SVALUE;
            else if (sload) q_q <= data;
            else if (cnt_en && cin) begin
                if (up) q_q <= at_end ? 0 : q_q + 1'b1;
                else q_q <= at_end ? LAST : q_q - 1'b1;
            end
        end

    assign q = q_q;
    assign cout = at_end && cin;
    assign eq = 16'd1 << q_q[(LPM_WIDTH > 4 ? 4 : LPM_WIDTH)-1:0];
// verilator lint_on WIDTH
endmodule

`default_nettype wire
