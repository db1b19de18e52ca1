// de1sim_pll.v - Platform Designer's PLLs: an altera_pll under the names of their ports
//
// altera_pll, and the University Program's for the SDRAM, video and audio: each connects the ports
// that it has.

`default_nettype none
// A text that is not given is shorter.
// verilator lint_off WIDTH

module de1sim_pll #(
    parameter output_clock_frequency0 = "0 MHz", parameter phase_shift0 = "0 ps",
    parameter output_clock_frequency1 = "0 MHz", parameter phase_shift1 = "0 ps",
    parameter output_clock_frequency2 = "0 MHz", parameter phase_shift2 = "0 ps",
    parameter output_clock_frequency3 = "0 MHz", parameter phase_shift3 = "0 ps",
    parameter output_clock_frequency4 = "0 MHz", parameter phase_shift4 = "0 ps",
    parameter output_clock_frequency5 = "0 MHz", parameter phase_shift5 = "0 ps",
    parameter output_clock_frequency6 = "0 MHz", parameter phase_shift6 = "0 ps",
    parameter output_clock_frequency7 = "0 MHz", parameter phase_shift7 = "0 ps"
) (
    input  wire refclk,
    input  wire rst,
    output wire outclk_0,
    output wire outclk_1,
    output wire outclk_2,
    output wire outclk_3,
    output wire outclk_4,
    output wire outclk_5,
    output wire outclk_6,
    output wire outclk_7,
    output wire locked,
    output wire not_locked
);
    wire [7:0] outclk;
    assign {outclk_7, outclk_6, outclk_5, outclk_4} = outclk[7:4];
    assign {outclk_3, outclk_2, outclk_1, outclk_0} = outclk[3:0];
    assign not_locked = !locked;

    // verilator lint_off PINMISSING
    altera_pll #(
        .number_of_clocks(8),
        .output_clock_frequency0(output_clock_frequency0), .phase_shift0(phase_shift0),
        .output_clock_frequency1(output_clock_frequency1), .phase_shift1(phase_shift1),
        .output_clock_frequency2(output_clock_frequency2), .phase_shift2(phase_shift2),
        .output_clock_frequency3(output_clock_frequency3), .phase_shift3(phase_shift3),
        .output_clock_frequency4(output_clock_frequency4), .phase_shift4(phase_shift4),
        .output_clock_frequency5(output_clock_frequency5), .phase_shift5(phase_shift5),
        .output_clock_frequency6(output_clock_frequency6), .phase_shift6(phase_shift6),
        .output_clock_frequency7(output_clock_frequency7), .phase_shift7(phase_shift7)
    ) pll (.refclk(refclk), .rst(rst), .outclk(outclk), .locked(locked));
    // verilator lint_on PINMISSING

// verilator lint_on WIDTH
endmodule

`default_nettype wire
