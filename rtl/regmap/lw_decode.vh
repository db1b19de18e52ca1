// lw_decode.vh - generated from regmap.def by `make regmap`; do not edit.
// The select line of the block that gets an access on the lightweight bridge.

function [31:0] line_of;
    // All registers are words, and the upper bits are not looked at.
    // verilator lint_off UNUSED
    input [20:0] addr;
    // verilator lint_on UNUSED
    input write;
    begin
        line_of = 32'd0;
        line_of[SEL_LEDR] = addr[14:4] == LEDR_BASE[14:4];
        line_of[SEL_HEX3_0] = addr[14:4] == HEX3_0_BASE[14:4];
        line_of[SEL_HEX5_4] = addr[14:4] == HEX5_4_BASE[14:4];
        line_of[SEL_SW] = !write && addr[14:4] == SW_BASE[14:4];
        line_of[SEL_KEY] = addr[14:4] == KEY_BASE[14:4];
        line_of[SEL_JP1] = addr[14:4] == JP1_BASE[14:4];
        line_of[SEL_JP2] = addr[14:4] == JP2_BASE[14:4];
        line_of[SEL_PS2_0] = addr[14:3] == PS2_0_BASE[14:3];
        line_of[SEL_PS2_1] = addr[14:3] == PS2_1_BASE[14:3];
        line_of[SEL_JTAG_UART0] = addr[14:3] == JTAG_UART0_BASE[14:3];
        line_of[SEL_JTAG_UART1] = addr[14:3] == JTAG_UART1_BASE[14:3];
        line_of[SEL_IRDA] = addr[14:3] == IRDA_BASE[14:3];
        line_of[SEL_TIMER0] = addr[14:5] == TIMER0_BASE[14:5];
        line_of[SEL_TIMER1] = addr[14:5] == TIMER1_BASE[14:5];
        line_of[SEL_SYSID] = !write && addr[14:3] == SYSID_BASE[14:3];
        line_of[SEL_RESAMPLER] = !write && addr[14:2] == RESAMPLER_BASE[14:2];
        line_of[SEL_PIXEL] = addr[14:4] == PIXEL_BASE[14:4];
        line_of[SEL_TEXT] = addr[14:4] == TEXT_BASE[14:4];
        line_of[SEL_VIDEO_IN] = addr[14:4] == VIDEO_IN_BASE[14:4];
        line_of[SEL_EDGE_DETECTION] = addr[14:4] == EDGE_DETECTION_BASE[14:4];
        line_of[SEL_AV_CONFIG] = addr[14:4] == AV_CONFIG_BASE[14:4];
        line_of[SEL_AUDIO] = addr[14:4] == AUDIO_BASE[14:4];
        line_of[SEL_ADC] = addr[14:5] == ADC_BASE[14:5];
        line_of[SEL_KEYPAD] = addr[14:5] == KEYPAD_BASE[14:5];
        line_of[SEL_CODEC] = addr[14:4] == CODEC_BASE[14:4];
        if (line_of == 32'd0) line_of[SEL_TIMER0] = 1'b1;
    end
endfunction
