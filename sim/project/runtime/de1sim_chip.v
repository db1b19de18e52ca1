// de1sim_chip.v - the chip around somebody's design: the board's pins as the simulation has them
//
// de1sim_design.vh, which is written for each project, instances the design between the wires that
// are declared here under the schematic's names, and drives those outputs that it has not.
//
// A clock input of this module moves once per clock: de1sim_clock makes a whole pulse of it in one
// evaluation.  For waveforms (DE1SIM_TRACE) it is the clock itself.
//
// The video DAC and the SDRAM take their pins at a rising edge of a clock that the design makes, so
// these are sampled here, as they would be in their input registers.
//
// The other inputs are taken over when moved_i changes.  An evaluation then need not look at them,
// and all that hangs on them, at every clock.
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
    output wire [41:0] hex_no,          // HEX5 in 41:35 ... HEX0 in 6:0

    input  wire [35:0] gpio_0_low_i,
    output wire [35:0] gpio_0_o,
    output wire [35:0] gpio_0_oe_o,     // an inout pin counts as driven where it is low
    input  wire [35:0] gpio_1_low_i,
    output wire [35:0] gpio_1_o,
    output wire [35:0] gpio_1_oe_o,

    output wire [27:0] vga_o,           // SYNC_N, BLANK_N, VS, HS, R, G, B at the last sample
    output wire        vga_sample_o,    // moves with each sample

    output wire [20:0] dram_o,          // CS_N, RAS_N, CAS_N, WE_N, BA, ADDR, UDQM, LDQM
    output wire        dram_sample_o,
    output wire [15:0] dram_dq_o,
    input  wire [15:0] dram_dq_i,
    input  wire        dram_dq_en_i,

    input  wire [2:0]  aud_i,           // BCLK, DACLRCK, ADCLRCK where the codec drives them
    input  wire        aud_en_i,
    output wire [2:0]  aud_o,
    output wire        aud_xck_o,       // moves with every 128th rise of AUD_XCK
    output wire        aud_dacdat_o,
    input  wire        aud_adcdat_i,
    output wire        i2c_sclk_o,
    output wire        i2c_sdat_o,
    input  wire        i2c_sdat_low_i,

    output wire [2:0]  adc_o,           // DIN, SCLK, CS_N
    input  wire        adc_dout_i,

    input  wire [1:0]  ps2_clk_low_i,
    input  wire [1:0]  ps2_dat_low_i,
    output wire [1:0]  ps2_clk_o,
    output wire [1:0]  ps2_dat_o,

    input  wire        irda_rxd_i,
    input  wire [7:0]  td_data_i
);
    // ---- Clocks ----

    wire        CLOCK_50, TD_CLK27;
    wire [63:0] pll_clocks;             // taken from here by de1sim_pll_tap

    de1sim_clock clock_50(.clk_i(clock_50_i), .clk_o(CLOCK_50));
    de1sim_clock clock_27(.clk_i(clock_27_i), .clk_o(TD_CLK27));

    wire CLOCK2_50 = CLOCK_50;
    wire CLOCK3_50 = CLOCK_50;
    wire CLOCK4_50 = CLOCK_50;

    genvar n;
    generate
        for (n = 0; n < `DE1SIM_PLL_CLOCKS; n = n + 1) begin : pll
            de1sim_clock clock(.clk_i(pll_clocks_i[n]), .clk_o(pll_clocks[n]));
        end
    endgenerate

    // ---- Wires of the board ----

    reg  [3:0]  KEY = 4'hf;
    reg  [9:0]  SW = 10'd0;
    reg  [35:0] gpio_0_low = 36'd0, gpio_1_low = 36'd0;
    reg  [15:0] dram_dq = 16'd0;
    reg         dram_dq_en = 1'b0;
    reg         AUD_ADCDAT = 1'b0, ADC_DOUT = 1'b0, IRDA_RXD = 1'b1;
    reg         i2c_sdat_low = 1'b0;
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
        aud <= aud_i;
        aud_en <= aud_en_i;
        ps2_clk_low <= ps2_clk_low_i;
        ps2_dat_low <= ps2_dat_low_i;
    end

    wire [7:0]  TD_DATA = td_data_i;
    wire        TD_HS    = 1'b1;
    wire        TD_VS    = 1'b1;

    wire [9:0]  LEDR;
    wire [6:0]  HEX0, HEX1, HEX2, HEX3, HEX4, HEX5;
    wire        VGA_CLK, VGA_HS, VGA_VS, VGA_BLANK_N, VGA_SYNC_N;
    wire [7:0]  VGA_R, VGA_G, VGA_B;
    wire        DRAM_CLK, DRAM_CKE, DRAM_CS_N, DRAM_RAS_N, DRAM_CAS_N, DRAM_WE_N;
    wire [1:0]  DRAM_BA;
    wire [12:0] DRAM_ADDR;
    wire        DRAM_LDQM, DRAM_UDQM;
    wire        AUD_XCK, AUD_DACDAT, FPGA_I2C_SCLK;
    wire        ADC_CS_N, ADC_SCLK, ADC_DIN;
    wire        IRDA_TXD, TD_RESET_N, FAN_CTRL;

    wire [35:0] GPIO_0, GPIO_1;
    wire [15:0] DRAM_DQ;
    wire        AUD_BCLK, AUD_DACLRCK, AUD_ADCLRCK, FPGA_I2C_SDAT;
    wire        PS2_CLK, PS2_DAT, PS2_CLK2, PS2_DAT2;

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
    pullup(FPGA_I2C_SCLK);
    pullup(FPGA_I2C_SDAT);
    pullup(PS2_CLK);
    pullup(PS2_DAT);
    pullup(PS2_CLK2);
    pullup(PS2_DAT2);

    // ---- The design ----

`include "de1sim_design.vh"

    // ---- What the simulation looks at ----

    assign ledr_o = LEDR;
    assign hex_no = {HEX5, HEX4, HEX3, HEX2, HEX1, HEX0};
    assign gpio_0_o = GPIO_0;
    assign gpio_1_o = GPIO_1;
    assign gpio_0_oe_o = `DE1SIM_GPIO_0_OUTPUTS | ~GPIO_0 & ~gpio_0_low;
    assign gpio_1_oe_o = `DE1SIM_GPIO_1_OUTPUTS | ~GPIO_1 & ~gpio_1_low;
    assign aud_o = {AUD_BCLK, AUD_DACLRCK, AUD_ADCLRCK};
    assign aud_xck_o = xck_rises_q[7];
    assign aud_dacdat_o = AUD_DACDAT;
    assign i2c_sclk_o = FPGA_I2C_SCLK;
    assign i2c_sdat_o = FPGA_I2C_SDAT;
    assign adc_o = {ADC_DIN, ADC_SCLK, ADC_CS_N};
    assign ps2_clk_o = {PS2_CLK2, PS2_CLK};
    assign ps2_dat_o = {PS2_DAT2, PS2_DAT};
    assign dram_dq_o = dram_dq_q;
    assign dram_o = dram_q;
    assign dram_sample_o = dram_sample_q;
    assign vga_o = vga_q;
    assign vga_sample_o = vga_sample_q;

    reg [7:0] xck_rises_q = 8'd0;

    always @(posedge AUD_XCK) xck_rises_q <= xck_rises_q + 8'd1;

    reg [27:0] vga_q = 28'd0;
    reg        vga_sample_q = 1'b0;

    always @(posedge `DE1SIM_VGA_CLK) begin
        vga_q <= {VGA_SYNC_N, VGA_BLANK_N, VGA_VS, VGA_HS, VGA_R, VGA_G, VGA_B};
        vga_sample_q <= ~vga_sample_q;
    end

    reg [20:0] dram_q = 21'h1fffff;
    reg [15:0] dram_dq_q = 16'd0;
    reg        dram_sample_q = 1'b0;

    always @(posedge DRAM_CLK) begin
        dram_q <= {DRAM_CS_N, DRAM_RAS_N, DRAM_CAS_N, DRAM_WE_N, DRAM_BA, DRAM_ADDR, DRAM_UDQM,
                   DRAM_LDQM};
        dram_dq_q <= DRAM_DQ;
        dram_sample_q <= ~dram_sample_q;
    end
endmodule

// A pulse for each change of clk_i, within one evaluation; for waveforms a wire.
module de1sim_clock (
    input  wire clk_i,
    output wire clk_o
);
`ifdef DE1SIM_TRACE
    assign clk_o = clk_i;
`else
    reg seen_q = 1'b0;

    assign clk_o = clk_i ^ seen_q;
    always @(posedge clk_o) seen_q <= clk_i;
`endif
endmodule

`default_nettype wire
