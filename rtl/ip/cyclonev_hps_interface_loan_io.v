// cyclonev_hps_interface_loan_io.v - pins of the processor's that the FPGA has
//
// Bits 28:0 are GPIO0's pins, 57:29 GPIO1's, 66:58 GPIO2's, 70:67 inputs alone, which are high.  A
// pin is the FPGA's while its bit of LOANED and of loanio_oe is 1: on the board it is whichever the
// preloader has given away.
//
// Not handled: the pins at GPIO_IN, GPIO_OUT and GPIO_OE, which Platform Designer connects to the
// pads: they are those of the board without it.

`default_nettype none

module cyclonev_hps_interface_loan_io #(
    // The device's primitive has none.
    parameter [70:0] loaned = -1, LOANED = loaned  // all
) (
    input  wire [70:0] loanio_out,
    input  wire [70:0] loanio_oe,
    output wire [70:0] loanio_in,
    output wire [13:0] input_only,
    output wire        fake_dout,
    // verilator lint_off UNUSED
    input  wire [70:0] GPIO_IN,
    // verilator lint_on UNUSED
    output wire [70:0] GPIO_OUT,
    output wire [70:0] GPIO_OE
);
    wire [70:0] oe = loanio_oe & LOANED;

    de1sim_hps_wires #(
        .KIND(4), .NUMBER(0), .FROM(58), .TO(29), .IDLE(64'h1fffffff)
    ) pins0 (
        .from_i({oe[28:0], loanio_out[28:0]}), .to_o(loanio_in[28:0])
    );
    de1sim_hps_wires #(
        .KIND(4), .NUMBER(1), .FROM(58), .TO(29), .IDLE(64'h1fffffff)
    ) pins1 (
        .from_i({oe[57:29], loanio_out[57:29]}), .to_o(loanio_in[57:29])
    );
    de1sim_hps_wires #(
        .KIND(4), .NUMBER(2), .FROM(58), .TO(29), .IDLE(64'h1fffffff)
    ) pins2 (
        .from_i({20'd0, oe[66:58], 20'd0, loanio_out[66:58]}), .to_o({unused, loanio_in[70:58]})
    );

    // verilator lint_off UNUSED
    wire [15:0] unused;
    wire        unused_too = &{1'b0, loanio_out[70:67], oe[70:67]};
    // verilator lint_on UNUSED

    assign input_only = {14{1'b1}};
    assign fake_dout  = 1'b0;
    assign GPIO_OUT   = loanio_out;
    assign GPIO_OE    = oe;
endmodule

`default_nettype wire
