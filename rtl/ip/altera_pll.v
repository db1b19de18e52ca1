// altera_pll.v - the Cyclone V's PLL, as Quartus's generated files instantiate it
//
// outclk[i] is a clock of output_clock_frequencyI, phase_shiftI and duty_cycleI, all texts like
// "25.175000 MHz" and "0 ps"; those from number_of_clocks on, and those of 0 MHz, do not exist.
// It is 0 while rst is high.  Of pll_subtype "Reconfigurable" the counters are m_cnt_hi_div,
// c_cnt_hi_div0 and so on, until an altera_pll_reconfig_top writes others.
//
// Not handled: the reference's true frequency, dynamic phase, a second reference, clocks of which
// only the counters are given; of two reconfigurable PLLs of the same clocks one alone is set.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module altera_pll #(
    parameter number_of_clocks = 1, NUMBER_OF_CLOCKS = number_of_clocks,
    parameter output_clock_frequency0 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY0 = output_clock_frequency0,
    parameter phase_shift0 = "0 ps", PHASE_SHIFT0 = phase_shift0,
    parameter duty_cycle0 = 50, DUTY_CYCLE0 = duty_cycle0,
    parameter output_clock_frequency1 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY1 = output_clock_frequency1,
    parameter phase_shift1 = "0 ps", PHASE_SHIFT1 = phase_shift1,
    parameter duty_cycle1 = 50, DUTY_CYCLE1 = duty_cycle1,
    parameter output_clock_frequency2 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY2 = output_clock_frequency2,
    parameter phase_shift2 = "0 ps", PHASE_SHIFT2 = phase_shift2,
    parameter duty_cycle2 = 50, DUTY_CYCLE2 = duty_cycle2,
    parameter output_clock_frequency3 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY3 = output_clock_frequency3,
    parameter phase_shift3 = "0 ps", PHASE_SHIFT3 = phase_shift3,
    parameter duty_cycle3 = 50, DUTY_CYCLE3 = duty_cycle3,
    parameter output_clock_frequency4 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY4 = output_clock_frequency4,
    parameter phase_shift4 = "0 ps", PHASE_SHIFT4 = phase_shift4,
    parameter duty_cycle4 = 50, DUTY_CYCLE4 = duty_cycle4,
    parameter output_clock_frequency5 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY5 = output_clock_frequency5,
    parameter phase_shift5 = "0 ps", PHASE_SHIFT5 = phase_shift5,
    parameter duty_cycle5 = 50, DUTY_CYCLE5 = duty_cycle5,
    parameter output_clock_frequency6 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY6 = output_clock_frequency6,
    parameter phase_shift6 = "0 ps", PHASE_SHIFT6 = phase_shift6,
    parameter duty_cycle6 = 50, DUTY_CYCLE6 = duty_cycle6,
    parameter output_clock_frequency7 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY7 = output_clock_frequency7,
    parameter phase_shift7 = "0 ps", PHASE_SHIFT7 = phase_shift7,
    parameter duty_cycle7 = 50, DUTY_CYCLE7 = duty_cycle7,
    parameter output_clock_frequency8 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY8 = output_clock_frequency8,
    parameter phase_shift8 = "0 ps", PHASE_SHIFT8 = phase_shift8,
    parameter duty_cycle8 = 50, DUTY_CYCLE8 = duty_cycle8,
    parameter output_clock_frequency9 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY9 = output_clock_frequency9,
    parameter phase_shift9 = "0 ps", PHASE_SHIFT9 = phase_shift9,
    parameter duty_cycle9 = 50, DUTY_CYCLE9 = duty_cycle9,
    parameter output_clock_frequency10 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY10 = output_clock_frequency10,
    parameter phase_shift10 = "0 ps", PHASE_SHIFT10 = phase_shift10,
    parameter duty_cycle10 = 50, DUTY_CYCLE10 = duty_cycle10,
    parameter output_clock_frequency11 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY11 = output_clock_frequency11,
    parameter phase_shift11 = "0 ps", PHASE_SHIFT11 = phase_shift11,
    parameter duty_cycle11 = 50, DUTY_CYCLE11 = duty_cycle11,
    parameter output_clock_frequency12 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY12 = output_clock_frequency12,
    parameter phase_shift12 = "0 ps", PHASE_SHIFT12 = phase_shift12,
    parameter duty_cycle12 = 50, DUTY_CYCLE12 = duty_cycle12,
    parameter output_clock_frequency13 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY13 = output_clock_frequency13,
    parameter phase_shift13 = "0 ps", PHASE_SHIFT13 = phase_shift13,
    parameter duty_cycle13 = 50, DUTY_CYCLE13 = duty_cycle13,
    parameter output_clock_frequency14 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY14 = output_clock_frequency14,
    parameter phase_shift14 = "0 ps", PHASE_SHIFT14 = phase_shift14,
    parameter duty_cycle14 = 50, DUTY_CYCLE14 = duty_cycle14,
    parameter output_clock_frequency15 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY15 = output_clock_frequency15,
    parameter phase_shift15 = "0 ps", PHASE_SHIFT15 = phase_shift15,
    parameter duty_cycle15 = 50, DUTY_CYCLE15 = duty_cycle15,
    parameter output_clock_frequency16 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY16 = output_clock_frequency16,
    parameter phase_shift16 = "0 ps", PHASE_SHIFT16 = phase_shift16,
    parameter duty_cycle16 = 50, DUTY_CYCLE16 = duty_cycle16,
    parameter output_clock_frequency17 = "0 MHz",
    parameter OUTPUT_CLOCK_FREQUENCY17 = output_clock_frequency17,
    parameter phase_shift17 = "0 ps", PHASE_SHIFT17 = phase_shift17,
    parameter duty_cycle17 = 50, DUTY_CYCLE17 = duty_cycle17,
    `include "altera_pll_ignored.vh"
) (
    input  wire                        refclk, refclk1, fbclk, rst,
    output wire [NUMBER_OF_CLOCKS-1:0] outclk,
    output wire                        locked, fboutclk,
    inout  wire                        zdbfbclk,

    input  wire [63:0]                 reconfig_to_pll,
    output wire [63:0]                 reconfig_from_pll,
    input  wire                        phase_en, updn, scanclk, extswitch, adjpllin, cclk,
    input  wire [2:0]                  num_phase_shifts,
    input  wire [4:0]                  cntsel,
    output wire                        phase_done, activeclk, cascade_out,
    output wire [1:0]                  clkbad, extclk_out, loaden, lvds_clk,
    output wire [7:0]                  phout
);
    `include "de1sim_units.vh"

    function [8*40-1:0] frequency(input integer i);
        case (i)
            0: frequency = OUTPUT_CLOCK_FREQUENCY0;
            1: frequency = OUTPUT_CLOCK_FREQUENCY1;
            2: frequency = OUTPUT_CLOCK_FREQUENCY2;
            3: frequency = OUTPUT_CLOCK_FREQUENCY3;
            4: frequency = OUTPUT_CLOCK_FREQUENCY4;
            5: frequency = OUTPUT_CLOCK_FREQUENCY5;
            6: frequency = OUTPUT_CLOCK_FREQUENCY6;
            7: frequency = OUTPUT_CLOCK_FREQUENCY7;
            8: frequency = OUTPUT_CLOCK_FREQUENCY8;
            9: frequency = OUTPUT_CLOCK_FREQUENCY9;
            10: frequency = OUTPUT_CLOCK_FREQUENCY10;
            11: frequency = OUTPUT_CLOCK_FREQUENCY11;
            12: frequency = OUTPUT_CLOCK_FREQUENCY12;
            13: frequency = OUTPUT_CLOCK_FREQUENCY13;
            14: frequency = OUTPUT_CLOCK_FREQUENCY14;
            15: frequency = OUTPUT_CLOCK_FREQUENCY15;
            16: frequency = OUTPUT_CLOCK_FREQUENCY16;
            17: frequency = OUTPUT_CLOCK_FREQUENCY17;
            default: frequency = 0;
        endcase
    endfunction
    function [8*40-1:0] phase(input integer i);
        case (i)
            0: phase = PHASE_SHIFT0;
            1: phase = PHASE_SHIFT1;
            2: phase = PHASE_SHIFT2;
            3: phase = PHASE_SHIFT3;
            4: phase = PHASE_SHIFT4;
            5: phase = PHASE_SHIFT5;
            6: phase = PHASE_SHIFT6;
            7: phase = PHASE_SHIFT7;
            8: phase = PHASE_SHIFT8;
            9: phase = PHASE_SHIFT9;
            10: phase = PHASE_SHIFT10;
            11: phase = PHASE_SHIFT11;
            12: phase = PHASE_SHIFT12;
            13: phase = PHASE_SHIFT13;
            14: phase = PHASE_SHIFT14;
            15: phase = PHASE_SHIFT15;
            16: phase = PHASE_SHIFT16;
            17: phase = PHASE_SHIFT17;
            default: phase = 0;
        endcase
    endfunction
    function [63:0] duty(input integer i);
        case (i)
            0: duty = DUTY_CYCLE0;
            1: duty = DUTY_CYCLE1;
            2: duty = DUTY_CYCLE2;
            3: duty = DUTY_CYCLE3;
            4: duty = DUTY_CYCLE4;
            5: duty = DUTY_CYCLE5;
            6: duty = DUTY_CYCLE6;
            7: duty = DUTY_CYCLE7;
            8: duty = DUTY_CYCLE8;
            9: duty = DUTY_CYCLE9;
            10: duty = DUTY_CYCLE10;
            11: duty = DUTY_CYCLE11;
            12: duty = DUTY_CYCLE12;
            13: duty = DUTY_CYCLE13;
            14: duty = DUTY_CYCLE14;
            15: duty = DUTY_CYCLE15;
            16: duty = DUTY_CYCLE16;
            17: duty = DUTY_CYCLE17;
            default: duty = 0;
        endcase
    endfunction

    function [17:0] packed_of(input integer high, input integer low, input [8*40-1:0] bypass,
                              input [8*40-1:0] odd);
        packed_of = {odd == "true", bypass == "true", high[7:0], low[7:0]};
    endfunction
    function [17:0] counter(input integer i);
        case (i)
            0: counter = packed_of(C_CNT_HI_DIV0, C_CNT_LO_DIV0, C_CNT_BYPASS_EN0,
                                   C_CNT_ODD_DIV_DUTY_EN0);
            1: counter = packed_of(C_CNT_HI_DIV1, C_CNT_LO_DIV1, C_CNT_BYPASS_EN1,
                                   C_CNT_ODD_DIV_DUTY_EN1);
            2: counter = packed_of(C_CNT_HI_DIV2, C_CNT_LO_DIV2, C_CNT_BYPASS_EN2,
                                   C_CNT_ODD_DIV_DUTY_EN2);
            3: counter = packed_of(C_CNT_HI_DIV3, C_CNT_LO_DIV3, C_CNT_BYPASS_EN3,
                                   C_CNT_ODD_DIV_DUTY_EN3);
            4: counter = packed_of(C_CNT_HI_DIV4, C_CNT_LO_DIV4, C_CNT_BYPASS_EN4,
                                   C_CNT_ODD_DIV_DUTY_EN4);
            5: counter = packed_of(C_CNT_HI_DIV5, C_CNT_LO_DIV5, C_CNT_BYPASS_EN5,
                                   C_CNT_ODD_DIV_DUTY_EN5);
            6: counter = packed_of(C_CNT_HI_DIV6, C_CNT_LO_DIV6, C_CNT_BYPASS_EN6,
                                   C_CNT_ODD_DIV_DUTY_EN6);
            7: counter = packed_of(C_CNT_HI_DIV7, C_CNT_LO_DIV7, C_CNT_BYPASS_EN7,
                                   C_CNT_ODD_DIV_DUTY_EN7);
            8: counter = packed_of(C_CNT_HI_DIV8, C_CNT_LO_DIV8, C_CNT_BYPASS_EN8,
                                   C_CNT_ODD_DIV_DUTY_EN8);
            9: counter = packed_of(C_CNT_HI_DIV9, C_CNT_LO_DIV9, C_CNT_BYPASS_EN9,
                                   C_CNT_ODD_DIV_DUTY_EN9);
            10: counter = packed_of(C_CNT_HI_DIV10, C_CNT_LO_DIV10, C_CNT_BYPASS_EN10,
                                   C_CNT_ODD_DIV_DUTY_EN10);
            11: counter = packed_of(C_CNT_HI_DIV11, C_CNT_LO_DIV11, C_CNT_BYPASS_EN11,
                                   C_CNT_ODD_DIV_DUTY_EN11);
            12: counter = packed_of(C_CNT_HI_DIV12, C_CNT_LO_DIV12, C_CNT_BYPASS_EN12,
                                   C_CNT_ODD_DIV_DUTY_EN12);
            13: counter = packed_of(C_CNT_HI_DIV13, C_CNT_LO_DIV13, C_CNT_BYPASS_EN13,
                                   C_CNT_ODD_DIV_DUTY_EN13);
            14: counter = packed_of(C_CNT_HI_DIV14, C_CNT_LO_DIV14, C_CNT_BYPASS_EN14,
                                   C_CNT_ODD_DIV_DUTY_EN14);
            15: counter = packed_of(C_CNT_HI_DIV15, C_CNT_LO_DIV15, C_CNT_BYPASS_EN15,
                                   C_CNT_ODD_DIV_DUTY_EN15);
            16: counter = packed_of(C_CNT_HI_DIV16, C_CNT_LO_DIV16, C_CNT_BYPASS_EN16,
                                   C_CNT_ODD_DIV_DUTY_EN16);
            17: counter = packed_of(C_CNT_HI_DIV17, C_CNT_LO_DIV17, C_CNT_BYPASS_EN17,
                                   C_CNT_ODD_DIV_DUTY_EN17);
            default: counter = 0;
        endcase
    endfunction
    function [18*18-1:0] counters(input integer unused);
        integer i;
        for (i = 0; i < 18; i = i + 1) counters[18*i +: 18] = counter(i);
    endfunction

    localparam SETTABLE = PLL_SUBTYPE == "Reconfigurable";
    wire               sets, unlocks;
    wire [18*64-1:0]   periods_fs, highs_fs;
    generate
        if (SETTABLE) begin : reconfigured
            de1sim_pll_counters #(
                .REFERENCE_FS(de1sim_period_fs(REFERENCE_CLOCK_FREQUENCY)),
                .FRACTIONAL(FRACTIONAL_VCO_MULTIPLIER == "true"), .K(PLL_FRACTIONAL_DIVISION),
                .M(packed_of(M_CNT_HI_DIV, M_CNT_LO_DIV, M_CNT_BYPASS_EN, M_CNT_ODD_DIV_DUTY_EN)),
                .N(packed_of(N_CNT_HI_DIV, N_CNT_LO_DIV, N_CNT_BYPASS_EN, N_CNT_ODD_DIV_DUTY_EN)),
                .C(counters(0))
            ) at_work (
                .reconfig_to_pll(reconfig_to_pll), .reconfig_from_pll(reconfig_from_pll),
                .set_o(sets), .unlocks_o(unlocks), .period_fs_o(periods_fs),
                .high_fs_o(highs_fs));
        end else begin : fixed
            assign {sets, unlocks, periods_fs, highs_fs} = 0;
            assign reconfig_from_pll = 64'd0;
        end
    endgenerate

    de1sim_pll_lock lock (.refclk_i(refclk), .rst_i(rst || unlocks), .locked_o(locked));

    genvar i;
    generate
        for (i = 0; i < NUMBER_OF_CLOCKS; i = i + 1) begin : output_clock
            localparam [63:0] PERIOD_FS = de1sim_period_fs(frequency(i));
            if (PERIOD_FS != 0) begin : used
                wire clk;
                de1sim_pll_tap #(
                    .PERIOD_FS(PERIOD_FS), .PHASE_FS(de1sim_phase_fs(phase(i), PERIOD_FS)),
                    .HIGH_FS(PERIOD_FS * duty(i) / 100), .SETTABLE(SETTABLE ? 64'd1 : 64'd0)
                ) tap (.clk(clk), .set_i(sets), .period_fs_i(periods_fs[64*i +: 64]),
                       .high_fs_i(highs_fs[64*i +: 64]));
                assign outclk[i] = clk && !rst;
            end else begin : unused
                assign outclk[i] = 1'b0;
            end
        end
    endgenerate

    assign fboutclk = 1'b0;
    assign phase_done = 1'b1;
    assign activeclk = 1'b0;
    assign cascade_out = 1'b0;
    assign clkbad = 2'd0;
    assign extclk_out = 2'd0;
    assign loaden = 2'd0;
    assign lvds_clk = 2'd0;
    assign phout = 8'd0;
// verilator lint_on WIDTH
endmodule

`default_nettype wire
