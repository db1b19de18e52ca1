// altddio_out.v - two bits per clock out of a pin
//
// Both are taken at the rising edge: dataout is datain_h while outclock is high, then datain_l.
//
// Not handled: oe, which counts as 1.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module altddio_out #(
    parameter width = 1, WIDTH = width,
    parameter power_up_high = "OFF", POWER_UP_HIGH = power_up_high,
    parameter invert_output = "OFF", INVERT_OUTPUT = invert_output,
    // Without meaning here.
    parameter extend_oe_disable = "OFF", EXTEND_OE_DISABLE = extend_oe_disable,
    parameter oe_reg = "UNUSED", OE_REG = oe_reg,
    parameter lpm_type = "altddio_out", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint
) (
    input  wire             outclock, outclocken,
    input  wire             aclr, aset, sclr, sset,
    input  wire             oe,
    input  wire [WIDTH-1:0] datain_h, datain_l,
    output wire [WIDTH-1:0] dataout, oe_out
);
    localparam [WIDTH-1:0] POWER_UP = {WIDTH{POWER_UP_HIGH == "ON"}};

    reg [WIDTH-1:0] high_q = POWER_UP, low_q = POWER_UP;
    always @(posedge outclock or posedge aclr or posedge aset)
        if (aclr || aset) begin
            high_q <= {WIDTH{!aclr}};
            low_q <= {WIDTH{!aclr}};
        end else if (outclocken) begin
            high_q <= sclr ? {WIDTH{1'b0}} : sset ? {WIDTH{1'b1}} : datain_h;
            low_q <= sclr ? {WIDTH{1'b0}} : sset ? {WIDTH{1'b1}} : datain_l;
        end

    assign dataout = (outclock ? high_q : low_q) ^ {WIDTH{INVERT_OUTPUT == "ON"}};
    assign oe_out = {WIDTH{1'b1}};
// verilator lint_on WIDTH
endmodule

`default_nettype wire
