// fiftyfivenm_adcblock.v - the converter of a MAX 10, as the Modular ADC core's Verilog names it
//
//   clkin_from_pll_c0  2, 10, 20, 40 or 80 MHz, by clkdiv 1 to 5
//   clk_dft            that divided to 1 MHz, one conversion in each period
//   soc                1 = convert            usr_pwd  1 = off
//   chsel              the input, numbered as the chip's wires are
//
//   clk_dft  __/^^^^^^^^\________/^^^^^^^^\________/
//   eoc      ________________/^^^\____________/^^^\_   falls as clk_dft rises
//   dout     ----------------X---------------X------   of the input as it is then
//
// On the DE10-Lite an input of 0 to 5 V is halved before the chip, whose reference is 2.5 V; so 5 V
// is the end of the 4,096 steps.  Arduino_A0 to A5 are the first converter's channels 1 to 6.
//
// Source: MAX 10 Analog to Digital Converter User Guide; the comments and the table of channels in
// the Modular ADC core's Verilog; DE10-Lite User Manual, "Arduino Uno R3 Expansion Header".  That
// clkdiv 2 is 10 MHz, and 5 is 80 MHz, is what systems generated for these clocks have; the numbers
// between are a guess.
//
// Not handled: temperature (tsen), which reads 0; the prescaler; other references than one that
// makes 5 V the end; channels 0 and 7 to 16 and the second converter, which are at 0 V; noise.

`default_nettype none

module fiftyfivenm_adcblock #(
    parameter clkdiv = 1, CLKDIV = clkdiv,
    parameter is_this_first_or_second_adc = 1,
    parameter IS_THIS_FIRST_OR_SECOND_ADC = is_this_first_or_second_adc,
    // verilator lint_off UNUSED
    parameter tsclkdiv = 0, TSCLKDIV = tsclkdiv,
    parameter tsclksel = 0, TSCLKSEL = tsclksel,
    parameter prescalar = 0, PRESCALAR = prescalar,
    parameter refsel = 0, REFSEL = refsel,
    parameter pwd = 0, PWD = pwd,
    parameter analog_input_pin_mask = 0, ANALOG_INPUT_PIN_MASK = analog_input_pin_mask,
    parameter enable_usr_sim = 0, ENABLE_USR_SIM = enable_usr_sim,
    parameter reference_voltage_sim = 65536, REFERENCE_VOLTAGE_SIM = reference_voltage_sim,
    parameter device_partname_fivechar_prefix = "10M50",
    parameter DEVICE_PARTNAME_FIVECHAR_PREFIX = device_partname_fivechar_prefix,
    parameter simfilename_ch0 = "", SIMFILENAME_CH0 = simfilename_ch0,
    parameter simfilename_ch1 = "", SIMFILENAME_CH1 = simfilename_ch1,
    parameter simfilename_ch2 = "", SIMFILENAME_CH2 = simfilename_ch2,
    parameter simfilename_ch3 = "", SIMFILENAME_CH3 = simfilename_ch3,
    parameter simfilename_ch4 = "", SIMFILENAME_CH4 = simfilename_ch4,
    parameter simfilename_ch5 = "", SIMFILENAME_CH5 = simfilename_ch5,
    parameter simfilename_ch6 = "", SIMFILENAME_CH6 = simfilename_ch6,
    parameter simfilename_ch7 = "", SIMFILENAME_CH7 = simfilename_ch7,
    parameter simfilename_ch8 = "", SIMFILENAME_CH8 = simfilename_ch8,
    parameter simfilename_ch9 = "", SIMFILENAME_CH9 = simfilename_ch9,
    parameter simfilename_ch10 = "", SIMFILENAME_CH10 = simfilename_ch10,
    parameter simfilename_ch11 = "", SIMFILENAME_CH11 = simfilename_ch11,
    parameter simfilename_ch12 = "", SIMFILENAME_CH12 = simfilename_ch12,
    parameter simfilename_ch13 = "", SIMFILENAME_CH13 = simfilename_ch13,
    parameter simfilename_ch14 = "", SIMFILENAME_CH14 = simfilename_ch14,
    parameter simfilename_ch15 = "", SIMFILENAME_CH15 = simfilename_ch15,
    parameter simfilename_ch16 = "", SIMFILENAME_CH16 = simfilename_ch16,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "fiftyfivenm_adcblock", LPM_TYPE = lpm_type
    // verilator lint_on UNUSED
) (
    input  wire        clkin_from_pll_c0,
    input  wire        soc,
    input  wire        usr_pwd,
    input  wire        tsen,
    input  wire [4:0]  chsel,
    output reg         clk_dft,
    output reg         eoc,
    output reg  [11:0] dout
);
    `include "de1sim_analog.vh"

    localparam [6:0] PERIOD = CLKDIV == 1 ? 7'd2 : CLKDIV == 2 ? 7'd10 : CLKDIV == 3 ? 7'd20 :
                              CLKDIV == 4 ? 7'd40 : 7'd80;
    localparam integer FULL_MV = 5000, STEPS = 4096;

    initial if (CLKDIV < 1 || CLKDIV > 5) begin
        $display("fiftyfivenm_adcblock: clkdiv is %0d, expected 1 to 5", CLKDIV);
        $finish;
    end

    // The board's input at the first converter's wire; 8: none.
    function [3:0] input_of;
        input [4:0] wire_number;
        case (wire_number)
            5'd4:    input_of = 4'd0;
            5'd6:    input_of = 4'd1;
            5'd10:   input_of = 4'd2;
            5'd12:   input_of = 4'd3;
            5'd16:   input_of = 4'd4;
            5'd14:   input_of = 4'd5;
            default: input_of = 4'd8;
        endcase
    endfunction

    wire [3:0] number = IS_THIS_FIRST_OR_SECOND_ADC == 1 && !tsen ? input_of(chsel) : 4'd8;
    integer    steps;
    reg  [6:0] count = 7'd0;  // clocks of the period

    // verilator lint_off BLKSEQ
    // verilator lint_off WIDTH
    always @(posedge clkin_from_pll_c0) begin
        count   <= count == PERIOD - 7'd1 ? 7'd0 : count + 7'd1;
        clk_dft <= count < PERIOD / 7'd2;
        if (count == 7'd0) eoc <= 1'b0;
        if (count == PERIOD - (PERIOD + 7'd3) / 7'd4 && soc && !usr_pwd) begin
            steps = number[3] ? 0 : de1sim_analog_mv(number) * STEPS / FULL_MV;
            dout <= steps > STEPS - 1 ? STEPS - 1 : steps;
            eoc  <= 1'b1;
        end
    end
    // verilator lint_on WIDTH
    // verilator lint_on BLKSEQ
endmodule

`default_nettype wire
