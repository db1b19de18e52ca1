// lw_blocks.vh - numbers of the blocks' select lines behind the lightweight bridge.
// Every module uses a few of these constants.
// verilator lint_off UNUSEDPARAM
localparam SEL_LEDR      = 0;
localparam SEL_HEX3_0    = 1;
localparam SEL_HEX5_4    = 2;
localparam SEL_SW        = 3;
localparam SEL_KEY       = 4;
localparam SEL_JP1       = 5;
localparam SEL_JP2       = 6;
localparam SEL_SYSID     = 7;
localparam SEL_RESAMPLER = 8;
localparam SEL_PIXEL     = 9;
localparam SEL_AUDIO     = 10;   // AUDIO, AV_CONFIG and CODEC
localparam SEL_KEYPAD    = 11;
localparam SEL_TIMER0    = 12;
localparam SEL_TIMER1    = 13;
localparam SEL_JTAG0     = 14;   // JTAG_UART0
localparam SEL_JTAG1     = 15;
localparam SEL_PS2_0     = 16;
localparam SEL_PS2_1     = 17;
localparam SEL_TEXT      = 18;
localparam SELECTS       = 19;
// verilator lint_on UNUSEDPARAM
