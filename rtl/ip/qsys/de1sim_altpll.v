// de1sim_altpll.v - Platform Designer's Avalon ALTPLL: a PLL of up to five clocks, with registers
//
//   0  status   bit 0 locked
//   1  control  bit 0 1 = reset; reads back
//
// Source: Embedded Peripherals IP User Guide, "Avalon ALTPLL Core".
//
// Not handled: phase reconfiguration, pfdena, phasedone, which is 1.

`default_nettype none

module de1sim_altpll #(
    parameter output_clock_frequency0 = "0 MHz", parameter phase_shift0 = "0 ps",
    parameter output_clock_frequency1 = "0 MHz", parameter phase_shift1 = "0 ps",
    parameter output_clock_frequency2 = "0 MHz", parameter phase_shift2 = "0 ps",
    parameter output_clock_frequency3 = "0 MHz", parameter phase_shift3 = "0 ps",
    parameter output_clock_frequency4 = "0 MHz", parameter phase_shift4 = "0 ps"
) (
    input  wire        clk,
    input  wire        reset,
    input  wire        areset,
    output wire        c0,
    output wire        c1,
    output wire        c2,
    output wire        c3,
    output wire        c4,
    output wire        locked,
    output wire        phasedone,

    input  wire        read,
    input  wire        write,
    input  wire [1:0]  address,
    // verilator lint_off UNUSED
    input  wire [31:0] writedata,
    // verilator lint_on UNUSED
    output wire [31:0] readdata
);
    reg held_q;

    assign phasedone = 1'b1;
    assign readdata  = !read ? 32'd0 : address == 2'd0 ? {31'd0, locked}
                       : address == 2'd1 ? {31'd0, held_q} : 32'd0;

    always @(posedge clk or posedge reset)
        if (reset) held_q <= 1'b0;
        else if (write && address == 2'd1) held_q <= writedata[0];

    // verilator lint_off PINMISSING
    // verilator lint_off WIDTH
    de1sim_pll #(
        .output_clock_frequency0(output_clock_frequency0), .phase_shift0(phase_shift0),
        .output_clock_frequency1(output_clock_frequency1), .phase_shift1(phase_shift1),
        .output_clock_frequency2(output_clock_frequency2), .phase_shift2(phase_shift2),
        .output_clock_frequency3(output_clock_frequency3), .phase_shift3(phase_shift3),
        .output_clock_frequency4(output_clock_frequency4), .phase_shift4(phase_shift4)
    ) pll (
        .refclk(clk), .rst(areset || held_q), .outclk_0(c0), .outclk_1(c1), .outclk_2(c2),
        .outclk_3(c3), .outclk_4(c4), .locked(locked)
    );
    // verilator lint_on WIDTH
    // verilator lint_on PINMISSING
endmodule

`default_nettype wire
