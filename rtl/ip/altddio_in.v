// altddio_in.v - two bits per clock from a pin
//
// dataout_h is what was there at the rising edge, dataout_l what at the falling edge before it;
// both change at the rising edge.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module altddio_in #(
    parameter width = 1, WIDTH = width,
    parameter power_up_high = "OFF", POWER_UP_HIGH = power_up_high,
    parameter invert_input_clocks = "OFF", INVERT_INPUT_CLOCKS = invert_input_clocks,
    // Without meaning here.
    parameter implement_input_in_lcell = "ON", IMPLEMENT_INPUT_IN_LCELL = implement_input_in_lcell,
    parameter lpm_type = "altddio_in", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint
) (
    input  wire             inclock, inclocken,
    input  wire             aclr, aset, sclr, sset,
    input  wire [WIDTH-1:0] datain,
    output wire [WIDTH-1:0] dataout_h, dataout_l
);
    localparam [WIDTH-1:0] POWER_UP = {WIDTH{POWER_UP_HIGH == "ON"}};

    wire clock = inclock ^ (INVERT_INPUT_CLOCKS == "ON");
    wire [WIDTH-1:0] next = sclr ? {WIDTH{1'b0}} : sset ? {WIDTH{1'b1}} : datain;

    reg [WIDTH-1:0] high_q = POWER_UP, low_q = POWER_UP, falling_q = POWER_UP;
    always @(negedge clock or posedge aclr or posedge aset)
        if (aclr || aset) falling_q <= {WIDTH{!aclr}};
        else if (inclocken) falling_q <= next;
    always @(posedge clock or posedge aclr or posedge aset)
        if (aclr || aset) begin
            high_q <= {WIDTH{!aclr}};
            low_q <= {WIDTH{!aclr}};
        end else if (inclocken) begin
            high_q <= next;
            low_q <= falling_q;
        end

    assign dataout_h = high_q;
    assign dataout_l = low_q;
// verilator lint_on WIDTH
endmodule

`default_nettype wire
