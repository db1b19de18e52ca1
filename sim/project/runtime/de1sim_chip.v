// de1sim_chip.v - the chip around somebody's design: the board's pins as the simulation has them
//
// de1sim_design.vh, which is written for each project, instances the design between the wires that
// are declared here under the schematic's names, and drives those outputs that it has not.
//
// Each edge of a clock is an evaluation of its own, in which the pins move once: what a part of the
// board has on its pins when its clock rises is what was there before that evaluation.
//
// The inputs that are no clocks are taken over when moved_i changes.  An evaluation then need not
// look at them, and all that hangs on them, at every clock.
//
// A wire that both sides may drive has a pull-up, as on the board: X_low_i says where the outside
// pulls it low, X_o is its level.

`default_nettype none

module de1sim_chip (
    input  wire        clock_50_i,
    input  wire        clock_27_i,      // the video decoder's
    input  wire [63:0] pll_clocks_i,

    input  wire        moved_i,         // changes after an input below has

    input  wire [3:0]  key_ni,
    input  wire [9:0]  sw_i,
    output wire [9:0]  ledr_o,
    output wire [47:0] hex_no,          // HEX5 in 41:35 ... HEX0 in 6:0; points, 1: lit, in 47:42

    input  wire [35:0] gpio_0_low_i,
    output wire [35:0] gpio_0_o,
    output wire [35:0] gpio_0_oe_o,     // an inout pin counts as driven where it is low
    input  wire [35:0] gpio_1_low_i,
    output wire [35:0] gpio_1_o,
    output wire [35:0] gpio_1_oe_o,

    output wire [2:0]  clocks_o,        // VGA_CLK, DRAM_CLK, AUD_XCK
    // I2C SDAT, SCLK; AUD_DACDAT, BCLK, DACLRCK, ADCLRCK; PS/2 DAT2, DAT, CLK2, CLK; ADC DIN, SCLK,
    // CS_N; above, the accelerometer's SDO, SDI, SCLK, CS_N
    output wire [16:0] pins_o,

    output wire [27:0] vga_o,           // SYNC_N, BLANK_N, VS, HS, R, G, B

    output wire [21:0] dram_o,          // CKE, CS_N, RAS_N, CAS_N, WE_N, BA, ADDR, UDQM, LDQM
    output wire [15:0] dram_dq_o,
    input  wire [15:0] dram_dq_i,
    input  wire        dram_dq_en_i,

    input  wire [2:0]  aud_i,           // BCLK, DACLRCK, ADCLRCK where the codec drives them
    input  wire        aud_en_i,
    input  wire        aud_adcdat_i,
    input  wire        i2c_sdat_low_i,

    input  wire        adc_dout_i,
    input  wire [1:0]  gsensor_low_i,   // SDO, SDI

    input  wire [1:0]  ps2_clk_low_i,
    input  wire [1:0]  ps2_dat_low_i,

    input  wire        irda_rxd_i,
    input  wire [7:0]  td_data_i,

    // The processor, where the design has a system with it (rtl/ip/de1sim_hps_port.v).
    input  wire        hps_moved_i,     // changes after an input below has
    input  wire [1:0]  hps_request_i,   // changes with a burst: 0 lightweight bridge, 1 full
    input  wire [1:0]  hps_reset_i,     // of the FPGA: h2f_cold_rst_n, h2f_rst_n, active high
    input  wire [31:0] hps_gp_i,        // general purpose signals: the processor's
    output wire [1:0]  hps_answer_o,    // follows hps_request_i
    output wire [3:0]  hps_size_o,      // buses, full and lightweight: 0: none, 1: 32 bits, 2: 64,
                                        // 3: 128
    output wire [39:0] hps_waits_o,     // of the same, for what a burst waits (bridge.h)
    output wire [63:0] hps_irq_o,       // IDs 72 to 135
    output wire [31:0] hps_gp_o,        // general purpose signals: the FPGA's
    output wire [2:0]  hps_reset_requests_o  // debug, warm, cold; active high
);
    // ---- Clocks ----

    wire        CLOCK_50, CLOCK2_50 = CLOCK_50, CLOCK3_50 = CLOCK_50, CLOCK4_50 = CLOCK_50;
    de1sim_clock_50 clock_50(.clk_i(clock_50_i), .clk_o(CLOCK_50));  // beside de1sim_pll_tap
    wire        TD_CLK27 = clock_27_i;
    wire [63:0] pll_clocks = pll_clocks_i;  // taken from here by de1sim_pll_tap

    // ---- Wires of the board ----

    reg  [3:0]  KEY = 4'hf;
    reg  [9:0]  SW = 10'd0;
    reg  [35:0] gpio_0_low = 36'd0, gpio_1_low = 36'd0;
    reg  [15:0] dram_dq = 16'd0;
    reg         dram_dq_en = 1'b0;
    reg         AUD_ADCDAT = 1'b0, ADC_DOUT = 1'b0, IRDA_RXD = 1'b1;
    reg         i2c_sdat_low = 1'b0;
    reg  [1:0]  gsensor_low = 2'd0;
    reg  [2:0]  aud = 3'd0;
    reg         aud_en = 1'b0;
    reg  [1:0]  ps2_clk_low = 2'd0, ps2_dat_low = 2'd0;

    always @(posedge moved_i or negedge moved_i) begin
        KEY <= key_ni;
        SW <= sw_i;
        gpio_0_low <= gpio_0_low_i;
        gpio_1_low <= gpio_1_low_i;
        dram_dq <= dram_dq_i;
        dram_dq_en <= dram_dq_en_i;
        AUD_ADCDAT <= aud_adcdat_i;
        ADC_DOUT <= adc_dout_i;
        IRDA_RXD <= irda_rxd_i;
        i2c_sdat_low <= i2c_sdat_low_i;
        gsensor_low <= gsensor_low_i;
        aud <= aud_i;
        aud_en <= aud_en_i;
        ps2_clk_low <= ps2_clk_low_i;
        ps2_dat_low <= ps2_dat_low_i;
    end

    wire [7:0]  TD_DATA = td_data_i;
    wire        TD_HS    = 1'b1;
    wire        TD_VS    = 1'b1;

    wire [9:0]  LEDR;
    wire [7:0]  HEX0, HEX1, HEX2, HEX3, HEX4, HEX5;
    wire        VGA_CLK, VGA_HS, VGA_VS, VGA_BLANK_N, VGA_SYNC_N;
    wire [7:0]  VGA_R, VGA_G, VGA_B;
    wire        DRAM_CLK, DRAM_CKE, DRAM_CS_N, DRAM_RAS_N, DRAM_CAS_N, DRAM_WE_N;
    wire [1:0]  DRAM_BA;
    wire [12:0] DRAM_ADDR;
    wire        DRAM_LDQM, DRAM_UDQM;
    wire        AUD_XCK, AUD_DACDAT, FPGA_I2C_SCLK;
    wire        ADC_CS_N, ADC_SCLK, ADC_DIN;
    wire        GSENSOR_CS_N, GSENSOR_SCLK, GSENSOR_SDI, GSENSOR_SDO;
    wire        IRDA_TXD, TD_RESET_N, FAN_CTRL;

    wire [35:0] GPIO_0, GPIO_1;
    wire [15:0] DRAM_DQ;
    wire        AUD_BCLK, AUD_DACLRCK, AUD_ADCLRCK, FPGA_I2C_SDAT;
    wire        PS2_CLK, PS2_DAT, PS2_CLK2, PS2_DAT2;

    genvar n;
    generate
        for (n = 0; n < 36; n = n + 1) begin : header
            pullup(GPIO_0[n]);
            pullup(GPIO_1[n]);
            assign GPIO_0[n] = gpio_0_low[n] ? 1'b0 : 1'bz;
            assign GPIO_1[n] = gpio_1_low[n] ? 1'b0 : 1'bz;
        end
    endgenerate

    assign DRAM_DQ = dram_dq_en ? dram_dq : 16'bz;
    assign AUD_BCLK = aud_en ? aud[2] : 1'bz;
    assign AUD_DACLRCK = aud_en ? aud[1] : 1'bz;
    assign AUD_ADCLRCK = aud_en ? aud[0] : 1'bz;
    assign FPGA_I2C_SDAT = i2c_sdat_low ? 1'b0 : 1'bz;
    assign PS2_CLK = ps2_clk_low[0] ? 1'b0 : 1'bz;
    assign PS2_DAT = ps2_dat_low[0] ? 1'b0 : 1'bz;
    assign PS2_CLK2 = ps2_clk_low[1] ? 1'b0 : 1'bz;
    assign PS2_DAT2 = ps2_dat_low[1] ? 1'b0 : 1'bz;
    assign GSENSOR_SDI = gsensor_low[0] ? 1'b0 : 1'bz;
    assign GSENSOR_SDO = gsensor_low[1] ? 1'b0 : 1'bz;
    pullup(GSENSOR_SCLK);
    pullup(GSENSOR_SDI);
    pullup(GSENSOR_SDO);
    pullup(FPGA_I2C_SCLK);
    pullup(FPGA_I2C_SDAT);
    pullup(PS2_CLK);
    pullup(PS2_DAT);
    pullup(PS2_CLK2);
    pullup(PS2_DAT2);

    reg  [1:0]  hps_request = 2'd0;
    reg  [1:0]  hps_reset = 2'd0;
    reg  [31:0] hps_gp = 32'd0;
    wire [1:0]  hps_answer;
    wire [3:0]  hps_size;
    wire [39:0] hps_waits;
    wire [63:0] hps_irq;
    wire [31:0] hps_fpga_gp;
    wire [2:0]  hps_reset_requests;

    always @(posedge hps_moved_i or negedge hps_moved_i) begin
        hps_request <= hps_request_i;
        hps_reset <= hps_reset_i;
        hps_gp <= hps_gp_i;
    end

    // ---- The design ----

`include "de1sim_design.vh"

    // ---- What the simulation looks at ----

    assign ledr_o = LEDR;
    assign hex_no = {~{HEX5[7], HEX4[7], HEX3[7], HEX2[7], HEX1[7], HEX0[7]},
                     HEX5[6:0], HEX4[6:0], HEX3[6:0], HEX2[6:0], HEX1[6:0], HEX0[6:0]};
    assign gpio_0_o = GPIO_0;
    assign gpio_1_o = GPIO_1;
    assign gpio_0_oe_o = `DE1SIM_GPIO_0_OUTPUTS | ~GPIO_0 & ~gpio_0_low;
    assign gpio_1_oe_o = `DE1SIM_GPIO_1_OUTPUTS | ~GPIO_1 & ~gpio_1_low;
    assign clocks_o = {VGA_CLK, DRAM_CLK, AUD_XCK};
    assign pins_o = {GSENSOR_SDO, GSENSOR_SDI, GSENSOR_SCLK, GSENSOR_CS_N,
                     FPGA_I2C_SDAT, FPGA_I2C_SCLK, AUD_DACDAT, AUD_BCLK, AUD_DACLRCK, AUD_ADCLRCK,
                     PS2_DAT2, PS2_DAT, PS2_CLK2, PS2_CLK, ADC_DIN, ADC_SCLK, ADC_CS_N};
    assign vga_o = {VGA_SYNC_N, VGA_BLANK_N, VGA_VS, VGA_HS, VGA_R, VGA_G, VGA_B};
    assign dram_o = {DRAM_CKE, DRAM_CS_N, DRAM_RAS_N, DRAM_CAS_N, DRAM_WE_N, DRAM_BA, DRAM_ADDR,
                     DRAM_UDQM, DRAM_LDQM};
    assign dram_dq_o = DRAM_DQ;
    assign hps_answer_o = hps_answer;
    assign hps_size_o = hps_size;
    assign hps_waits_o = hps_waits;
    assign hps_irq_o = hps_irq;
    assign hps_gp_o = hps_fpga_gp;
    assign hps_reset_requests_o = hps_reset_requests;
endmodule

`default_nettype wire
