// altddio_bidir.v - two bits per clock at a pin that is in and out
//
// altddio_out while oe is 1, and altddio_in always.
//
// Not handled: delays of DQS, a register of oe's second half (extend_oe_disable).

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module altddio_bidir #(
    parameter width = 1, WIDTH = width,
    parameter power_up_high = "OFF", POWER_UP_HIGH = power_up_high,
    parameter invert_output = "OFF", INVERT_OUTPUT = invert_output,
    parameter oe_reg = "UNUSED", OE_REG = oe_reg,
    // Without meaning here.
    parameter extend_oe_disable = "OFF", EXTEND_OE_DISABLE = extend_oe_disable,
    parameter implement_input_in_lcell = "UNUSED",
    parameter IMPLEMENT_INPUT_IN_LCELL = implement_input_in_lcell,
    parameter lpm_type = "altddio_bidir", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint
) (
    input  wire             inclock, inclocken, outclock, outclocken,
    input  wire             aclr, aset, sclr, sset,
    input  wire             oe,
    input  wire [WIDTH-1:0] datain_h, datain_l,
    output wire [WIDTH-1:0] dataout_h, dataout_l, combout, dqsundelayedout, oe_out,
    inout  wire [WIDTH-1:0] padio
);
    reg oe_q;
    always @(posedge outclock) if (outclocken) oe_q <= oe;
    wire drives = OE_REG == "REGISTERED" ? oe_q : oe;

    wire [WIDTH-1:0] out;
    altddio_out #(
        .WIDTH(WIDTH), .POWER_UP_HIGH(POWER_UP_HIGH), .INVERT_OUTPUT(INVERT_OUTPUT)
    ) half_out (
        .outclock(outclock), .outclocken(outclocken), .aclr(aclr), .aset(aset), .sclr(sclr),
        .sset(sset), .oe(1'b1), .datain_h(datain_h), .datain_l(datain_l), .dataout(out),
        .oe_out());
    altddio_in #(.WIDTH(WIDTH), .POWER_UP_HIGH(POWER_UP_HIGH)) half_in (
        .inclock(inclock), .inclocken(inclocken), .aclr(aclr), .aset(aset), .sclr(sclr),
        .sset(sset), .datain(padio), .dataout_h(dataout_h), .dataout_l(dataout_l));

    assign padio = drives ? out : {WIDTH{1'bz}};
    assign combout = padio;
    assign dqsundelayedout = padio;
    assign oe_out = {WIDTH{drives}};
// verilator lint_on WIDTH
endmodule

`default_nettype wire
