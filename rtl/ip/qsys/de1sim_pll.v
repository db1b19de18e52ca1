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
    parameter output_clock_frequency7 = "0 MHz", parameter phase_shift7 = "0 ps",
    // Where a program can change them: counters as of de1sim_pll_counters.v, C0 below.
    parameter             pll_subtype  = "General",
    parameter             reference    = "50.0 MHz",
    parameter             fractional   = "false",
    parameter [31:0]      K            = 32'd0,
    parameter [17:0]      M            = 18'd0,
    parameter [17:0]      N            = 18'd0,
    parameter [17:0]      C0 = 18'd0, parameter [17:0] C1 = 18'd0, parameter [17:0] C2 = 18'd0,
    parameter [17:0]      C3 = 18'd0, parameter [17:0] C4 = 18'd0, parameter [17:0] C5 = 18'd0,
    parameter [17:0]      C6 = 18'd0, parameter [17:0] C7 = 18'd0
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
    output wire not_locked,
    input  wire [63:0] reconfig_to_pll,
    output wire [63:0] reconfig_from_pll
);
    wire [7:0] outclk;
    assign {outclk_7, outclk_6, outclk_5, outclk_4} = outclk[7:4];
    assign {outclk_3, outclk_2, outclk_1, outclk_0} = outclk[3:0];
    assign not_locked = !locked;

    // verilator lint_off PINMISSING
    altera_pll #(
        .number_of_clocks(8),
        .pll_subtype(pll_subtype), .reference_clock_frequency(reference),
        .fractional_vco_multiplier(fractional), .pll_fractional_division(K),
        .m_cnt_hi_div(M[15:8]), .m_cnt_lo_div(M[7:0]),
        .m_cnt_bypass_en(M[16] ? "true" : "false"),
        .m_cnt_odd_div_duty_en(M[17] ? "true" : "false"),
        .n_cnt_hi_div(N[15:8]), .n_cnt_lo_div(N[7:0]),
        .n_cnt_bypass_en(N[16] ? "true" : "false"),
        .n_cnt_odd_div_duty_en(N[17] ? "true" : "false"),
        .c_cnt_hi_div0(C0[15:8]), .c_cnt_lo_div0(C0[7:0]),
        .c_cnt_bypass_en0(C0[16] ? "true" : "false"),
        .c_cnt_odd_div_duty_en0(C0[17] ? "true" : "false"),
        .c_cnt_hi_div1(C1[15:8]), .c_cnt_lo_div1(C1[7:0]),
        .c_cnt_bypass_en1(C1[16] ? "true" : "false"),
        .c_cnt_odd_div_duty_en1(C1[17] ? "true" : "false"),
        .c_cnt_hi_div2(C2[15:8]), .c_cnt_lo_div2(C2[7:0]),
        .c_cnt_bypass_en2(C2[16] ? "true" : "false"),
        .c_cnt_odd_div_duty_en2(C2[17] ? "true" : "false"),
        .c_cnt_hi_div3(C3[15:8]), .c_cnt_lo_div3(C3[7:0]),
        .c_cnt_bypass_en3(C3[16] ? "true" : "false"),
        .c_cnt_odd_div_duty_en3(C3[17] ? "true" : "false"),
        .c_cnt_hi_div4(C4[15:8]), .c_cnt_lo_div4(C4[7:0]),
        .c_cnt_bypass_en4(C4[16] ? "true" : "false"),
        .c_cnt_odd_div_duty_en4(C4[17] ? "true" : "false"),
        .c_cnt_hi_div5(C5[15:8]), .c_cnt_lo_div5(C5[7:0]),
        .c_cnt_bypass_en5(C5[16] ? "true" : "false"),
        .c_cnt_odd_div_duty_en5(C5[17] ? "true" : "false"),
        .c_cnt_hi_div6(C6[15:8]), .c_cnt_lo_div6(C6[7:0]),
        .c_cnt_bypass_en6(C6[16] ? "true" : "false"),
        .c_cnt_odd_div_duty_en6(C6[17] ? "true" : "false"),
        .c_cnt_hi_div7(C7[15:8]), .c_cnt_lo_div7(C7[7:0]),
        .c_cnt_bypass_en7(C7[16] ? "true" : "false"),
        .c_cnt_odd_div_duty_en7(C7[17] ? "true" : "false"),
        .output_clock_frequency0(output_clock_frequency0), .phase_shift0(phase_shift0),
        .output_clock_frequency1(output_clock_frequency1), .phase_shift1(phase_shift1),
        .output_clock_frequency2(output_clock_frequency2), .phase_shift2(phase_shift2),
        .output_clock_frequency3(output_clock_frequency3), .phase_shift3(phase_shift3),
        .output_clock_frequency4(output_clock_frequency4), .phase_shift4(phase_shift4),
        .output_clock_frequency5(output_clock_frequency5), .phase_shift5(phase_shift5),
        .output_clock_frequency6(output_clock_frequency6), .phase_shift6(phase_shift6),
        .output_clock_frequency7(output_clock_frequency7), .phase_shift7(phase_shift7)
    ) pll (.refclk(refclk), .rst(rst), .outclk(outclk), .locked(locked),
           .reconfig_to_pll(reconfig_to_pll), .reconfig_from_pll(reconfig_from_pll));
    // verilator lint_on PINMISSING

// verilator lint_on WIDTH
endmodule

`default_nettype wire
