// lw_decode.v - which block owns an address on the lightweight bridge
//
// Blocks are where regmap.def puts them.  No line is high where nobody is at home.

`default_nettype none

module lw_decode (
    input  wire        clk_i,
    input  wire        rst_i,
    input  wire        enable_i,
    input  wire [20:0] addr_i,   // offset in the bridge's 2 MB
    output reg  [19:0] sel_o,    // one line a block for one clock, numbered in lw_blocks.vh
    output reg         none_o,   // the last address had no block
    output wire        awake_o
);
    `include "regmap.vh"
    `include "lw_blocks.vh"

    function hit;
        input [20:0] addr;
        input [20:0] base;
        input [20:0] size;
        hit = ((addr ^ base) & ~(size - 21'd1)) == 21'd0;
    endfunction

    function [19:0] decode;
        input [20:0] addr;
        begin
            decode                = 20'd0;
            decode[SEL_LEDR]      = hit(addr, LEDR_BASE[20:0], LEDR_SIZE[20:0]);
            decode[SEL_HEX3_0]    = hit(addr, HEX3_0_BASE[20:0], HEX3_0_SIZE[20:0]);
            decode[SEL_HEX5_4]    = hit(addr, HEX5_4_BASE[20:0], HEX5_4_SIZE[20:0]);
            decode[SEL_SW]        = hit(addr, SW_BASE[20:0], SW_SIZE[20:0]);
            decode[SEL_KEY]       = hit(addr, KEY_BASE[20:0], KEY_SIZE[20:0]);
            decode[SEL_JP1]       = hit(addr, JP1_BASE[20:0], JP1_SIZE[20:0]);
            decode[SEL_JP2]       = hit(addr, JP2_BASE[20:0], JP2_SIZE[20:0]);
            decode[SEL_SYSID]     = hit(addr, SYSID_BASE[20:0], SYSID_SIZE[20:0]);
            decode[SEL_RESAMPLER] = hit(addr, RESAMPLER_BASE[20:0], RESAMPLER_SIZE[20:0]);
            decode[SEL_PIXEL]     = hit(addr, PIXEL_BASE[20:0], PIXEL_SIZE[20:0]);
            decode[SEL_AUDIO]     = hit(addr, AUDIO_BASE[20:0], AUDIO_SIZE[20:0])
                                    || hit(addr, AV_CONFIG_BASE[20:0], AV_CONFIG_SIZE[20:0])
                                    || hit(addr, CODEC_BASE[20:0], CODEC_SIZE[20:0]);
            decode[SEL_PS2_0]     = hit(addr, PS2_0_BASE[20:0], PS2_0_SIZE[20:0]);
            decode[SEL_PS2_1]     = hit(addr, PS2_1_BASE[20:0], PS2_1_SIZE[20:0]);
            decode[SEL_TEXT]      = hit(addr, TEXT_BASE[20:0], TEXT_SIZE[20:0]);
            decode[SEL_KEYPAD]    = hit(addr, KEYPAD_BASE[20:0], KEYPAD_SIZE[20:0]);
            decode[SEL_TIMER0]    = hit(addr, TIMER0_BASE[20:0], TIMER0_SIZE[20:0]);
            decode[SEL_TIMER1]    = hit(addr, TIMER1_BASE[20:0], TIMER1_SIZE[20:0]);
            decode[SEL_ADC]       = hit(addr, ADC_BASE[20:0], ADC_SIZE[20:0]);
            decode[SEL_JTAG0]     = hit(addr, JTAG_UART0_BASE[20:0], JTAG_UART0_SIZE[20:0]);
            decode[SEL_JTAG1]     = hit(addr, JTAG_UART1_BASE[20:0], JTAG_UART1_SIZE[20:0]);
        end
    endfunction

    assign awake_o = sel_o != 20'd0;

    always @(posedge clk_i) begin
        sel_o <= 20'd0;
        if (enable_i) begin
            sel_o  <= decode(addr_i);
            none_o <= decode(addr_i) == 20'd0;
        end
        if (rst_i) sel_o <= 20'd0;
    end
endmodule

`default_nettype wire
