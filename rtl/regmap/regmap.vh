// regmap.vh - generated from regmap.def by `make regmap`; do not edit.
// Every module uses a few of these constants.
// verilator lint_off UNUSEDPARAM
localparam [31:0] REGMAP_HASH = 32'h071d5e61;

localparam [31:0] PICTURE0_BASE = 32'hc8000000;
localparam [31:0] PICTURE0_SIZE = 32'h00080000;

localparam [31:0] PICTURE1_BASE = 32'hc0000000;
localparam [31:0] PICTURE1_SIZE = 32'h00080000;

localparam [31:0] CHARACTERS_BASE = 32'hc9000000;
localparam [31:0] CHARACTERS_SIZE = 32'h00002000;

localparam [31:0] LEDR_BASE = 32'hff200000;
localparam [31:0] LEDR_SIZE = 32'h00000010;
localparam [31:0] LEDR_DATA = 32'hff200000;
localparam [31:0] LEDR_DATA_RESET = 32'h00000000;
localparam LEDR_DATA_ON_LSB = 0;
localparam LEDR_DATA_ON_W = 10;

localparam [31:0] HEX3_0_BASE = 32'hff200020;
localparam [31:0] HEX3_0_SIZE = 32'h00000010;
localparam [31:0] HEX3_0_DATA = 32'hff200020;
localparam [31:0] HEX3_0_DATA_RESET = 32'h00000000;

localparam [31:0] HEX5_4_BASE = 32'hff200030;
localparam [31:0] HEX5_4_SIZE = 32'h00000010;
localparam [31:0] HEX5_4_DATA = 32'hff200030;
localparam [31:0] HEX5_4_DATA_RESET = 32'h00000000;

localparam [31:0] SW_BASE = 32'hff200040;
localparam [31:0] SW_SIZE = 32'h00000010;
localparam [31:0] SW_DATA = 32'hff200040;
localparam [31:0] SW_DATA_RESET = 32'h00000000;

localparam [31:0] KEY_BASE = 32'hff200050;
localparam [31:0] KEY_SIZE = 32'h00000010;
localparam [31:0] KEY_DATA = 32'hff200050;
localparam [31:0] KEY_DATA_RESET = 32'h00000000;
localparam [31:0] KEY_MASK = 32'hff200058;
localparam [31:0] KEY_MASK_RESET = 32'h00000000;
localparam [31:0] KEY_EDGE = 32'hff20005c;
localparam [31:0] KEY_EDGE_RESET = 32'h00000000;

localparam [31:0] JP1_BASE = 32'hff200060;
localparam [31:0] JP1_SIZE = 32'h00000010;
localparam [31:0] JP1_DATA = 32'hff200060;
localparam [31:0] JP1_DATA_RESET = 32'h00000000;
localparam [31:0] JP1_DIR = 32'hff200064;
localparam [31:0] JP1_DIR_RESET = 32'h00000000;
localparam [31:0] JP1_MASK = 32'hff200068;
localparam [31:0] JP1_MASK_RESET = 32'h00000000;
localparam [31:0] JP1_EDGE = 32'hff20006c;
localparam [31:0] JP1_EDGE_RESET = 32'h00000000;

localparam [31:0] JP2_BASE = 32'hff200070;
localparam [31:0] JP2_SIZE = 32'h00000010;
localparam [31:0] JP2_DATA = 32'hff200070;
localparam [31:0] JP2_DATA_RESET = 32'h00000000;
localparam [31:0] JP2_DIR = 32'hff200074;
localparam [31:0] JP2_DIR_RESET = 32'h00000000;
localparam [31:0] JP2_MASK = 32'hff200078;
localparam [31:0] JP2_MASK_RESET = 32'h00000000;
localparam [31:0] JP2_EDGE = 32'hff20007c;
localparam [31:0] JP2_EDGE_RESET = 32'h00000000;

localparam [31:0] PS2_0_BASE = 32'hff200100;
localparam [31:0] PS2_0_SIZE = 32'h00000008;
localparam [31:0] PS2_0_DATA = 32'hff200100;
localparam [31:0] PS2_0_DATA_RESET = 32'h00000000;
localparam PS2_0_DATA_DATA_LSB = 0;
localparam PS2_0_DATA_DATA_W = 8;
localparam PS2_0_DATA_RVALID_LSB = 15;
localparam PS2_0_DATA_RVALID_W = 1;
localparam PS2_0_DATA_RAVAIL_LSB = 16;
localparam PS2_0_DATA_RAVAIL_W = 16;
localparam [31:0] PS2_0_CONTROL = 32'hff200104;
localparam [31:0] PS2_0_CONTROL_RESET = 32'h00000000;
localparam PS2_0_CONTROL_RE_LSB = 0;
localparam PS2_0_CONTROL_RE_W = 1;
localparam PS2_0_CONTROL_RI_LSB = 8;
localparam PS2_0_CONTROL_RI_W = 1;
localparam PS2_0_CONTROL_CE_LSB = 10;
localparam PS2_0_CONTROL_CE_W = 1;

localparam [31:0] PS2_1_BASE = 32'hff200108;
localparam [31:0] PS2_1_SIZE = 32'h00000008;
localparam [31:0] PS2_1_DATA = 32'hff200108;
localparam [31:0] PS2_1_DATA_RESET = 32'h00000000;
localparam PS2_1_DATA_DATA_LSB = 0;
localparam PS2_1_DATA_DATA_W = 8;
localparam PS2_1_DATA_RVALID_LSB = 15;
localparam PS2_1_DATA_RVALID_W = 1;
localparam PS2_1_DATA_RAVAIL_LSB = 16;
localparam PS2_1_DATA_RAVAIL_W = 16;
localparam [31:0] PS2_1_CONTROL = 32'hff20010c;
localparam [31:0] PS2_1_CONTROL_RESET = 32'h00000000;
localparam PS2_1_CONTROL_RE_LSB = 0;
localparam PS2_1_CONTROL_RE_W = 1;
localparam PS2_1_CONTROL_RI_LSB = 8;
localparam PS2_1_CONTROL_RI_W = 1;
localparam PS2_1_CONTROL_CE_LSB = 10;
localparam PS2_1_CONTROL_CE_W = 1;

localparam [31:0] JTAG_UART0_BASE = 32'hff201000;
localparam [31:0] JTAG_UART0_SIZE = 32'h00000008;
localparam [31:0] JTAG_UART0_DATA = 32'hff201000;
localparam [31:0] JTAG_UART0_DATA_RESET = 32'h00000000;
localparam JTAG_UART0_DATA_DATA_LSB = 0;
localparam JTAG_UART0_DATA_DATA_W = 8;
localparam JTAG_UART0_DATA_RVALID_LSB = 15;
localparam JTAG_UART0_DATA_RVALID_W = 1;
localparam JTAG_UART0_DATA_RAVAIL_LSB = 16;
localparam JTAG_UART0_DATA_RAVAIL_W = 16;
localparam [31:0] JTAG_UART0_CONTROL = 32'hff201004;
localparam [31:0] JTAG_UART0_CONTROL_RESET = 32'h00400000;
localparam JTAG_UART0_CONTROL_RE_LSB = 0;
localparam JTAG_UART0_CONTROL_RE_W = 1;
localparam JTAG_UART0_CONTROL_WE_LSB = 1;
localparam JTAG_UART0_CONTROL_WE_W = 1;
localparam JTAG_UART0_CONTROL_RI_LSB = 8;
localparam JTAG_UART0_CONTROL_RI_W = 1;
localparam JTAG_UART0_CONTROL_WI_LSB = 9;
localparam JTAG_UART0_CONTROL_WI_W = 1;
localparam JTAG_UART0_CONTROL_AC_LSB = 10;
localparam JTAG_UART0_CONTROL_AC_W = 1;
localparam JTAG_UART0_CONTROL_WSPACE_LSB = 16;
localparam JTAG_UART0_CONTROL_WSPACE_W = 16;

localparam [31:0] JTAG_UART1_BASE = 32'hff201008;
localparam [31:0] JTAG_UART1_SIZE = 32'h00000008;
localparam [31:0] JTAG_UART1_DATA = 32'hff201008;
localparam [31:0] JTAG_UART1_DATA_RESET = 32'h00000000;
localparam JTAG_UART1_DATA_DATA_LSB = 0;
localparam JTAG_UART1_DATA_DATA_W = 8;
localparam JTAG_UART1_DATA_RVALID_LSB = 15;
localparam JTAG_UART1_DATA_RVALID_W = 1;
localparam JTAG_UART1_DATA_RAVAIL_LSB = 16;
localparam JTAG_UART1_DATA_RAVAIL_W = 16;
localparam [31:0] JTAG_UART1_CONTROL = 32'hff20100c;
localparam [31:0] JTAG_UART1_CONTROL_RESET = 32'h00400000;
localparam JTAG_UART1_CONTROL_RE_LSB = 0;
localparam JTAG_UART1_CONTROL_RE_W = 1;
localparam JTAG_UART1_CONTROL_WE_LSB = 1;
localparam JTAG_UART1_CONTROL_WE_W = 1;
localparam JTAG_UART1_CONTROL_RI_LSB = 8;
localparam JTAG_UART1_CONTROL_RI_W = 1;
localparam JTAG_UART1_CONTROL_WI_LSB = 9;
localparam JTAG_UART1_CONTROL_WI_W = 1;
localparam JTAG_UART1_CONTROL_AC_LSB = 10;
localparam JTAG_UART1_CONTROL_AC_W = 1;
localparam JTAG_UART1_CONTROL_WSPACE_LSB = 16;
localparam JTAG_UART1_CONTROL_WSPACE_W = 16;

localparam [31:0] TIMER0_BASE = 32'hff202000;
localparam [31:0] TIMER0_SIZE = 32'h00000020;
localparam [31:0] TIMER0_STATUS = 32'hff202000;
localparam [31:0] TIMER0_STATUS_RESET = 32'h00000000;
localparam TIMER0_STATUS_TO_LSB = 0;
localparam TIMER0_STATUS_TO_W = 1;
localparam TIMER0_STATUS_RUN_LSB = 1;
localparam TIMER0_STATUS_RUN_W = 1;
localparam [31:0] TIMER0_CONTROL = 32'hff202004;
localparam [31:0] TIMER0_CONTROL_RESET = 32'h00000000;
localparam TIMER0_CONTROL_ITO_LSB = 0;
localparam TIMER0_CONTROL_ITO_W = 1;
localparam TIMER0_CONTROL_CONT_LSB = 1;
localparam TIMER0_CONTROL_CONT_W = 1;
localparam TIMER0_CONTROL_START_LSB = 2;
localparam TIMER0_CONTROL_START_W = 1;
localparam TIMER0_CONTROL_STOP_LSB = 3;
localparam TIMER0_CONTROL_STOP_W = 1;
localparam [31:0] TIMER0_PERIOD_LOW = 32'hff202008;
localparam [31:0] TIMER0_PERIOD_LOW_RESET = 32'h0000bc1f;
localparam [31:0] TIMER0_PERIOD_HIGH = 32'hff20200c;
localparam [31:0] TIMER0_PERIOD_HIGH_RESET = 32'h000000be;
localparam [31:0] TIMER0_SNAP_LOW = 32'hff202010;
localparam [31:0] TIMER0_SNAP_LOW_RESET = 32'h00000000;
localparam [31:0] TIMER0_SNAP_HIGH = 32'hff202014;
localparam [31:0] TIMER0_SNAP_HIGH_RESET = 32'h00000000;

localparam [31:0] TIMER1_BASE = 32'hff202020;
localparam [31:0] TIMER1_SIZE = 32'h00000020;
localparam [31:0] TIMER1_STATUS = 32'hff202020;
localparam [31:0] TIMER1_STATUS_RESET = 32'h00000000;
localparam TIMER1_STATUS_TO_LSB = 0;
localparam TIMER1_STATUS_TO_W = 1;
localparam TIMER1_STATUS_RUN_LSB = 1;
localparam TIMER1_STATUS_RUN_W = 1;
localparam [31:0] TIMER1_CONTROL = 32'hff202024;
localparam [31:0] TIMER1_CONTROL_RESET = 32'h00000000;
localparam TIMER1_CONTROL_ITO_LSB = 0;
localparam TIMER1_CONTROL_ITO_W = 1;
localparam TIMER1_CONTROL_CONT_LSB = 1;
localparam TIMER1_CONTROL_CONT_W = 1;
localparam TIMER1_CONTROL_START_LSB = 2;
localparam TIMER1_CONTROL_START_W = 1;
localparam TIMER1_CONTROL_STOP_LSB = 3;
localparam TIMER1_CONTROL_STOP_W = 1;
localparam [31:0] TIMER1_PERIOD_LOW = 32'hff202028;
localparam [31:0] TIMER1_PERIOD_LOW_RESET = 32'h0000bc1f;
localparam [31:0] TIMER1_PERIOD_HIGH = 32'hff20202c;
localparam [31:0] TIMER1_PERIOD_HIGH_RESET = 32'h000000be;
localparam [31:0] TIMER1_SNAP_LOW = 32'hff202030;
localparam [31:0] TIMER1_SNAP_LOW_RESET = 32'h00000000;
localparam [31:0] TIMER1_SNAP_HIGH = 32'hff202034;
localparam [31:0] TIMER1_SNAP_HIGH_RESET = 32'h00000000;

localparam [31:0] SYSID_BASE = 32'hff202040;
localparam [31:0] SYSID_SIZE = 32'h00000008;
localparam [31:0] SYSID_ID = 32'hff202040;
localparam [31:0] SYSID_ID_RESET = 32'h44453153;
localparam [31:0] SYSID_HASH = 32'hff202044;
localparam [31:0] SYSID_HASH_RESET = 32'h00000000;

localparam [31:0] RESAMPLER_BASE = 32'hff203010;
localparam [31:0] RESAMPLER_SIZE = 32'h00000010;
localparam [31:0] RESAMPLER_STATUS = 32'hff203010;
localparam [31:0] RESAMPLER_STATUS_RESET = 32'h00000014;

localparam [31:0] PIXEL_BASE = 32'hff203020;
localparam [31:0] PIXEL_SIZE = 32'h00000010;
localparam [31:0] PIXEL_BUFFER = 32'hff203020;
localparam [31:0] PIXEL_BUFFER_RESET = 32'hc8000000;
localparam [31:0] PIXEL_BACK_BUFFER = 32'hff203024;
localparam [31:0] PIXEL_BACK_BUFFER_RESET = 32'hc8000000;
localparam [31:0] PIXEL_RESOLUTION = 32'hff203028;
localparam [31:0] PIXEL_RESOLUTION_RESET = 32'h00f00140;
localparam [31:0] PIXEL_STATUS = 32'hff20302c;
localparam [31:0] PIXEL_STATUS_RESET = 32'h08090f04;
localparam PIXEL_STATUS_S_LSB = 0;
localparam PIXEL_STATUS_S_W = 1;
localparam PIXEL_STATUS_A_LSB = 1;
localparam PIXEL_STATUS_A_W = 1;
localparam PIXEL_STATUS_EN_LSB = 2;
localparam PIXEL_STATUS_EN_W = 1;

localparam [31:0] TEXT_BASE = 32'hff203030;
localparam [31:0] TEXT_SIZE = 32'h00000010;
localparam [31:0] TEXT_BUFFER = 32'hff203030;
localparam [31:0] TEXT_BUFFER_RESET = 32'hc9000000;
localparam TEXT_BUFFER_CLEAR_LSB = 16;
localparam TEXT_BUFFER_CLEAR_W = 1;
localparam [31:0] TEXT_BACK_BUFFER = 32'hff203034;
localparam [31:0] TEXT_BACK_BUFFER_RESET = 32'hc9000000;
localparam [31:0] TEXT_RESOLUTION = 32'hff203038;
localparam [31:0] TEXT_RESOLUTION_RESET = 32'h003c0050;
localparam [31:0] TEXT_STATUS = 32'hff20303c;
localparam [31:0] TEXT_STATUS_RESET = 32'h06070004;
localparam TEXT_STATUS_S_LSB = 0;
localparam TEXT_STATUS_S_W = 1;
localparam TEXT_STATUS_A_LSB = 1;
localparam TEXT_STATUS_A_W = 1;
localparam TEXT_STATUS_EN_LSB = 2;
localparam TEXT_STATUS_EN_W = 1;

localparam [31:0] AV_CONFIG_BASE = 32'hff203000;
localparam [31:0] AV_CONFIG_SIZE = 32'h00000010;
localparam [31:0] AV_CONFIG_CONTROL = 32'hff203000;
localparam [31:0] AV_CONFIG_CONTROL_RESET = 32'h00000000;
localparam AV_CONFIG_CONTROL_RESET_LSB = 0;
localparam AV_CONFIG_CONTROL_RESET_W = 1;
localparam [31:0] AV_CONFIG_STATUS = 32'hff203004;
localparam [31:0] AV_CONFIG_STATUS_RESET = 32'h00000000;
localparam AV_CONFIG_STATUS_ACK_LSB = 0;
localparam AV_CONFIG_STATUS_ACK_W = 1;
localparam AV_CONFIG_STATUS_RDY_LSB = 1;
localparam AV_CONFIG_STATUS_RDY_W = 1;
localparam AV_CONFIG_STATUS_AIS_LSB = 8;
localparam AV_CONFIG_STATUS_AIS_W = 1;
localparam AV_CONFIG_STATUS_CFG_LSB = 16;
localparam AV_CONFIG_STATUS_CFG_W = 8;
localparam [31:0] AV_CONFIG_ADDRESS = 32'hff203008;
localparam [31:0] AV_CONFIG_ADDRESS_RESET = 32'h00000000;
localparam [31:0] AV_CONFIG_DATA = 32'hff20300c;
localparam [31:0] AV_CONFIG_DATA_RESET = 32'h00000000;

localparam [31:0] AUDIO_BASE = 32'hff203040;
localparam [31:0] AUDIO_SIZE = 32'h00000010;
localparam [31:0] AUDIO_CONTROL = 32'hff203040;
localparam [31:0] AUDIO_CONTROL_RESET = 32'h00000200;
localparam AUDIO_CONTROL_RE_LSB = 0;
localparam AUDIO_CONTROL_RE_W = 1;
localparam AUDIO_CONTROL_WE_LSB = 1;
localparam AUDIO_CONTROL_WE_W = 1;
localparam AUDIO_CONTROL_CR_LSB = 2;
localparam AUDIO_CONTROL_CR_W = 1;
localparam AUDIO_CONTROL_CW_LSB = 3;
localparam AUDIO_CONTROL_CW_W = 1;
localparam AUDIO_CONTROL_RI_LSB = 8;
localparam AUDIO_CONTROL_RI_W = 1;
localparam AUDIO_CONTROL_WI_LSB = 9;
localparam AUDIO_CONTROL_WI_W = 1;
localparam [31:0] AUDIO_FIFOSPACE = 32'hff203044;
localparam [31:0] AUDIO_FIFOSPACE_RESET = 32'h80800000;
localparam AUDIO_FIFOSPACE_RARC_LSB = 0;
localparam AUDIO_FIFOSPACE_RARC_W = 8;
localparam AUDIO_FIFOSPACE_RALC_LSB = 8;
localparam AUDIO_FIFOSPACE_RALC_W = 8;
localparam AUDIO_FIFOSPACE_WSRC_LSB = 16;
localparam AUDIO_FIFOSPACE_WSRC_W = 8;
localparam AUDIO_FIFOSPACE_WSLC_LSB = 24;
localparam AUDIO_FIFOSPACE_WSLC_W = 8;
localparam [31:0] AUDIO_LEFTDATA = 32'hff203048;
localparam [31:0] AUDIO_LEFTDATA_RESET = 32'h00000000;
localparam [31:0] AUDIO_RIGHTDATA = 32'hff20304c;
localparam [31:0] AUDIO_RIGHTDATA_RESET = 32'h00000000;

localparam [31:0] KEYPAD_BASE = 32'hff205000;
localparam [31:0] KEYPAD_SIZE = 32'h00000020;
localparam [31:0] KEYPAD_CONTROL = 32'hff205000;
localparam [31:0] KEYPAD_CONTROL_RESET = 32'h00000000;
localparam KEYPAD_CONTROL_EN_LSB = 0;
localparam KEYPAD_CONTROL_EN_W = 1;
localparam [31:0] KEYPAD_STATUS = 32'hff205004;
localparam [31:0] KEYPAD_STATUS_RESET = 32'h00000000;
localparam KEYPAD_STATUS_EVENT_LSB = 0;
localparam KEYPAD_STATUS_EVENT_W = 1;
localparam KEYPAD_STATUS_OVERFLOW_LSB = 1;
localparam KEYPAD_STATUS_OVERFLOW_W = 1;
localparam KEYPAD_STATUS_GHOST_LSB = 2;
localparam KEYPAD_STATUS_GHOST_W = 1;
localparam KEYPAD_STATUS_GHOST_HELD_LSB = 3;
localparam KEYPAD_STATUS_GHOST_HELD_W = 1;
localparam KEYPAD_STATUS_COUNT_LSB = 8;
localparam KEYPAD_STATUS_COUNT_W = 5;
localparam [31:0] KEYPAD_KEYS = 32'hff205008;
localparam [31:0] KEYPAD_KEYS_RESET = 32'h00000000;
localparam [31:0] KEYPAD_EVENT = 32'hff20500c;
localparam [31:0] KEYPAD_EVENT_RESET = 32'h00000000;
localparam KEYPAD_EVENT_KEY_LSB = 0;
localparam KEYPAD_EVENT_KEY_W = 4;
localparam KEYPAD_EVENT_PRESSED_LSB = 8;
localparam KEYPAD_EVENT_PRESSED_W = 1;
localparam KEYPAD_EVENT_VALID_LSB = 15;
localparam KEYPAD_EVENT_VALID_W = 1;
localparam [31:0] KEYPAD_DEBOUNCE = 32'hff205010;
localparam [31:0] KEYPAD_DEBOUNCE_RESET = 32'h00000019;
localparam KEYPAD_DEBOUNCE_SCANS_LSB = 0;
localparam KEYPAD_DEBOUNCE_SCANS_W = 8;
localparam [31:0] KEYPAD_MASK = 32'hff205014;
localparam [31:0] KEYPAD_MASK_RESET = 32'h00000000;

localparam [31:0] CODEC_BASE = 32'hff205100;
localparam [31:0] CODEC_SIZE = 32'h00000010;
localparam [31:0] CODEC_RATE = 32'hff205100;
localparam [31:0] CODEC_RATE_RESET = 32'h00000000;
localparam CODEC_RATE_FAST_LSB = 0;
localparam CODEC_RATE_FAST_W = 1;
localparam [31:0] CODEC_STATUS = 32'hff205104;
localparam [31:0] CODEC_STATUS_RESET = 32'h00000000;
localparam CODEC_STATUS_READY_LSB = 0;
localparam CODEC_STATUS_READY_W = 1;
localparam CODEC_STATUS_ERROR_LSB = 1;
localparam CODEC_STATUS_ERROR_W = 1;
localparam CODEC_STATUS_STEP_LSB = 4;
localparam CODEC_STATUS_STEP_W = 4;
localparam [31:0] CODEC_UNDERRUNS = 32'hff205108;
localparam [31:0] CODEC_UNDERRUNS_RESET = 32'h00000000;

localparam TIMER0_IRQ = 0;  // GIC ID 72

localparam KEY_IRQ = 1;  // GIC ID 73

localparam TIMER1_IRQ = 2;  // GIC ID 74

localparam AUDIO_IRQ = 6;  // GIC ID 78

localparam PS2_0_IRQ = 7;  // GIC ID 79

localparam JTAG_UART0_IRQ = 8;  // GIC ID 80

localparam JP1_IRQ = 11;  // GIC ID 83

localparam JP2_IRQ = 12;  // GIC ID 84

localparam KEYPAD_IRQ = 13;  // GIC ID 85

localparam PS2_1_IRQ = 17;  // GIC ID 89
// verilator lint_on UNUSEDPARAM
