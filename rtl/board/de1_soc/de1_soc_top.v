// de1_soc_top.v - the chip on the board: its pins, its clock, its processor, and fpga.v
//
//   CLOCK_50 -+-> clock_reset --> 25 MHz --> fpga.v, hps.v (its bridges run on the fabric's clock)
//             +-> audio_clock -+-> 12.288 MHz --> AUD_XCK
//                              +-> 128 * AUDIO_RATE --> fpga.v
//
// Pins are named as on the board's schematic, so that de1_soc.qsf can be checked against board.tsv.
// JP1 and JP2: bits 31:0 are the header's pins 35:19, 17, 15:3, 1; the four others stay open.
//
// Not handled: pins of parts that the system does not use (USB-Blaster, the video decoder's HS and
// VS); the project leaves them as inputs with weak pull-ups.

`default_nettype none

module de1_soc_top #(
    parameter AUDIO_RATE = 8000      // samples per second: 8000, the DE1-SoC Computer's, or 48000
) (
    input  wire        CLOCK_50,

    input  wire [3:0]  KEY,          // 0 = pressed
    input  wire [9:0]  SW,
    output wire [9:0]  LEDR,
    output wire [6:0]  HEX0,         // segments g..a, 0 = lit
    output wire [6:0]  HEX1,
    output wire [6:0]  HEX2,
    output wire [6:0]  HEX3,
    output wire [6:0]  HEX4,
    output wire [6:0]  HEX5,
    inout  wire [35:0] GPIO_0,       // JP1
    inout  wire [35:0] GPIO_1,       // JP2

    output wire        VGA_CLK,
    output wire        VGA_HS,
    output wire        VGA_VS,
    output wire        VGA_BLANK_N,
    output wire        VGA_SYNC_N,
    output wire [7:0]  VGA_R,
    output wire [7:0]  VGA_G,
    output wire [7:0]  VGA_B,

    output wire        DRAM_CLK,
    output wire        DRAM_CKE,
    output wire        DRAM_CS_N,
    output wire        DRAM_RAS_N,
    output wire        DRAM_CAS_N,
    output wire        DRAM_WE_N,
    output wire [1:0]  DRAM_BA,
    output wire [12:0] DRAM_ADDR,
    output wire        DRAM_LDQM,
    output wire        DRAM_UDQM,
    inout  wire [15:0] DRAM_DQ,

    output wire        AUD_XCK,
    output wire        AUD_BCLK,
    output wire        AUD_DACLRCK,
    output wire        AUD_DACDAT,
    output wire        AUD_ADCLRCK,
    input  wire        AUD_ADCDAT,
    output wire        FPGA_I2C_SCLK,
    inout  wire        FPGA_I2C_SDAT,

    output wire        ADC_CS_N,     // CONVST
    output wire        ADC_SCLK,
    output wire        ADC_DIN,
    input  wire        ADC_DOUT,

    inout  wire        PS2_CLK,
    inout  wire        PS2_DAT,
    inout  wire        PS2_CLK2,
    inout  wire        PS2_DAT2,

    input  wire        IRDA_RXD,
    output wire        IRDA_TXD,

    input  wire        TD_CLK27,     // ADV7180, which needs no set-up
    input  wire [7:0]  TD_DATA,
    output wire        TD_RESET_N
);
    localparam ID_W = 12;

    // ---- Clock and reset --------------------------------------------------
    wire clk, hps_rst_n, rst, clk_audio, rst_audio;

    audio_clock #(.RATE(AUDIO_RATE)) audio_clock (
        .refclk_i(CLOCK_50), .rst_ni(hps_rst_n), .xck_o(AUD_XCK), .clk_o(clk_audio),
        .rst_o(rst_audio)
    );
    // The audio clock's reset ends first: common/dual_clock_fifo.v.
    clock_reset clock_reset (
        .refclk_i(CLOCK_50), .rst_ni(hps_rst_n && !rst_audio), .clk_o(clk), .rst_o(rst)
    );

    // ---- Headers, I2C, PS/2: open unless driven ------------------------------
    wire [31:0] jp1, jp1_out, jp1_oe, jp2, jp2_out, jp2_oe;
    wire        sdat_oe;

    header header_0 (.pins_io(GPIO_0), .in_o(jp1), .out_i(jp1_out), .oe_i(jp1_oe));
    header header_1 (.pins_io(GPIO_1), .in_o(jp2), .out_i(jp2_out), .oe_i(jp2_oe));
    assign FPGA_I2C_SDAT = sdat_oe ? 1'b0 : 1'bz;

    wire [1:0]  ps2_clk_low, ps2_dat_low;

    assign PS2_CLK  = ps2_clk_low[0] ? 1'b0 : 1'bz;
    assign PS2_DAT  = ps2_dat_low[0] ? 1'b0 : 1'bz;
    assign PS2_CLK2 = ps2_clk_low[1] ? 1'b0 : 1'bz;
    assign PS2_DAT2 = ps2_dat_low[1] ? 1'b0 : 1'bz;

    // ---- Video decoder: out of its reset, else it drives nothing, its clock neither -----
    wire rst_td;

    assign TD_RESET_N = 1'b1;
    reset_sync td_reset_sync (.clk_i(TD_CLK27), .rst_ni(hps_rst_n), .rst_o(rst_td));

    // ---- SDRAM: its clock rises in the middle of a command ------------------
    wire [15:0] dram_dq;
    wire        dram_dq_oe;

    assign DRAM_CLK = ~clk;
    assign DRAM_CKE = 1'b1;
    assign DRAM_DQ  = dram_dq_oe ? dram_dq : 16'bz;

    // ---- Processor and fabric ---------------------------------------------
    wire [ID_W-1:0] lw_awid, lw_bid, lw_arid, lw_rid;
    wire [20:0]     lw_awaddr, lw_araddr;
    wire [3:0]      lw_awlen, lw_wstrb, lw_arlen;
    wire [2:0]      lw_awsize, lw_arsize;
    wire [1:0]      lw_awburst, lw_bresp, lw_arburst, lw_rresp;
    wire            lw_awvalid, lw_awready, lw_wvalid, lw_wready, lw_bvalid, lw_bready,
                    lw_arvalid, lw_arready, lw_rlast, lw_rvalid, lw_rready;
    wire [31:0]     lw_wdata, lw_rdata;

    wire [ID_W-1:0] h2f_awid, h2f_bid, h2f_arid, h2f_rid;
    wire [29:0]     h2f_awaddr, h2f_araddr;
    wire [3:0]      h2f_awlen, h2f_wstrb, h2f_arlen;
    wire [2:0]      h2f_awsize, h2f_arsize;
    wire [1:0]      h2f_awburst, h2f_bresp, h2f_arburst, h2f_rresp;
    wire            h2f_awvalid, h2f_awready, h2f_wvalid, h2f_wready, h2f_bvalid, h2f_bready,
                    h2f_arvalid, h2f_arready, h2f_rlast, h2f_rvalid, h2f_rready;
    wire [31:0]     h2f_wdata, h2f_rdata;
    wire [63:0]     irq;
    wire [1:0]      jtag_take, jtag_sent, jtag_room, jtag_typed, jtag_idle;
    wire [15:0]     jtag_sent_data, jtag_typed_data;

    hps #(.ID_W(ID_W)) hps (
        .clk_i                (clk),
        .rst_no               (hps_rst_n),
        .irq_i                (irq),

        .lw_awid_o            (lw_awid),
        .lw_awaddr_o          (lw_awaddr),
        .lw_awlen_o           (lw_awlen),
        .lw_awsize_o          (lw_awsize),
        .lw_awburst_o         (lw_awburst),
        .lw_awvalid_o         (lw_awvalid),
        .lw_awready_i         (lw_awready),
        .lw_wdata_o           (lw_wdata),
        .lw_wstrb_o           (lw_wstrb),
        .lw_wvalid_o          (lw_wvalid),
        .lw_wready_i          (lw_wready),
        .lw_bid_i             (lw_bid),
        .lw_bresp_i           (lw_bresp),
        .lw_bvalid_i          (lw_bvalid),
        .lw_bready_o          (lw_bready),
        .lw_arid_o            (lw_arid),
        .lw_araddr_o          (lw_araddr),
        .lw_arlen_o           (lw_arlen),
        .lw_arsize_o          (lw_arsize),
        .lw_arburst_o         (lw_arburst),
        .lw_arvalid_o         (lw_arvalid),
        .lw_arready_i         (lw_arready),
        .lw_rid_i             (lw_rid),
        .lw_rdata_i           (lw_rdata),
        .lw_rresp_i           (lw_rresp),
        .lw_rlast_i           (lw_rlast),
        .lw_rvalid_i          (lw_rvalid),
        .lw_rready_o          (lw_rready),

        .h2f_awid_o           (h2f_awid),
        .h2f_awaddr_o         (h2f_awaddr),
        .h2f_awlen_o          (h2f_awlen),
        .h2f_awsize_o         (h2f_awsize),
        .h2f_awburst_o        (h2f_awburst),
        .h2f_awvalid_o        (h2f_awvalid),
        .h2f_awready_i        (h2f_awready),
        .h2f_wdata_o          (h2f_wdata),
        .h2f_wstrb_o          (h2f_wstrb),
        .h2f_wvalid_o         (h2f_wvalid),
        .h2f_wready_i         (h2f_wready),
        .h2f_bid_i            (h2f_bid),
        .h2f_bresp_i          (h2f_bresp),
        .h2f_bvalid_i         (h2f_bvalid),
        .h2f_bready_o         (h2f_bready),
        .h2f_arid_o           (h2f_arid),
        .h2f_araddr_o         (h2f_araddr),
        .h2f_arlen_o          (h2f_arlen),
        .h2f_arsize_o         (h2f_arsize),
        .h2f_arburst_o        (h2f_arburst),
        .h2f_arvalid_o        (h2f_arvalid),
        .h2f_arready_i        (h2f_arready),
        .h2f_rid_i            (h2f_rid),
        .h2f_rdata_i          (h2f_rdata),
        .h2f_rresp_i          (h2f_rresp),
        .h2f_rlast_i          (h2f_rlast),
        .h2f_rvalid_i         (h2f_rvalid),
        .h2f_rready_o         (h2f_rready)
    );

    assign VGA_CLK = ~clk;   // rises in the middle of a pixel

    // On the device no clock is left out.
    // verilator lint_off PINCONNECTEMPTY
    fpga #(.ID_W(ID_W)) fpga (
        .clk_i                (clk),
        .rst_i                (rst),
        .clk_audio_i          (clk_audio),
        .rst_audio_i          (rst_audio),
        .audio_48k_i          (AUDIO_RATE == 48000),
        .clk_td_i             (TD_CLK27),
        .rst_td_i             (rst_td),

        .lw_awid_i            (lw_awid),
        .lw_awaddr_i          (lw_awaddr),
        .lw_awlen_i           (lw_awlen),
        .lw_awsize_i          (lw_awsize),
        .lw_awburst_i         (lw_awburst),
        .lw_awvalid_i         (lw_awvalid),
        .lw_awready_o         (lw_awready),
        .lw_wdata_i           (lw_wdata),
        .lw_wstrb_i           (lw_wstrb),
        .lw_wvalid_i          (lw_wvalid),
        .lw_wready_o          (lw_wready),
        .lw_bid_o             (lw_bid),
        .lw_bresp_o           (lw_bresp),
        .lw_bvalid_o          (lw_bvalid),
        .lw_bready_i          (lw_bready),
        .lw_arid_i            (lw_arid),
        .lw_araddr_i          (lw_araddr),
        .lw_arlen_i           (lw_arlen),
        .lw_arsize_i          (lw_arsize),
        .lw_arburst_i         (lw_arburst),
        .lw_arvalid_i         (lw_arvalid),
        .lw_arready_o         (lw_arready),
        .lw_rid_o             (lw_rid),
        .lw_rdata_o           (lw_rdata),
        .lw_rresp_o           (lw_rresp),
        .lw_rlast_o           (lw_rlast),
        .lw_rvalid_o          (lw_rvalid),
        .lw_rready_i          (lw_rready),

        .h2f_awid_i           (h2f_awid),
        .h2f_awaddr_i         (h2f_awaddr),
        .h2f_awlen_i          (h2f_awlen),
        .h2f_awsize_i         (h2f_awsize),
        .h2f_awburst_i        (h2f_awburst),
        .h2f_awvalid_i        (h2f_awvalid),
        .h2f_awready_o        (h2f_awready),
        .h2f_wdata_i          (h2f_wdata),
        .h2f_wstrb_i          (h2f_wstrb),
        .h2f_wvalid_i         (h2f_wvalid),
        .h2f_wready_o         (h2f_wready),
        .h2f_bid_o            (h2f_bid),
        .h2f_bresp_o          (h2f_bresp),
        .h2f_bvalid_o         (h2f_bvalid),
        .h2f_bready_i         (h2f_bready),
        .h2f_arid_i           (h2f_arid),
        .h2f_araddr_i         (h2f_araddr),
        .h2f_arlen_i          (h2f_arlen),
        .h2f_arsize_i         (h2f_arsize),
        .h2f_arburst_i        (h2f_arburst),
        .h2f_arvalid_i        (h2f_arvalid),
        .h2f_arready_o        (h2f_arready),
        .h2f_rid_o            (h2f_rid),
        .h2f_rdata_o          (h2f_rdata),
        .h2f_rresp_o          (h2f_rresp),
        .h2f_rlast_o          (h2f_rlast),
        .h2f_rvalid_o         (h2f_rvalid),
        .h2f_rready_i         (h2f_rready),

        .irq_o                (irq),

        .ledr_o               (LEDR),
        .hex_no               ({HEX5, HEX4, HEX3, HEX2, HEX1, HEX0}),
        .sw_i                 (SW),
        .key_ni               (KEY),
        .jp1_i                (jp1),
        .jp1_o                (jp1_out),
        .jp1_oe_o             (jp1_oe),
        .jp2_i                (jp2),
        .jp2_o                (jp2_out),
        .jp2_oe_o             (jp2_oe),

        .vga_hs_no            (VGA_HS),
        .vga_vs_no            (VGA_VS),
        .vga_blank_no         (VGA_BLANK_N),
        .vga_sync_no          (VGA_SYNC_N),
        .vga_r_o              (VGA_R),
        .vga_g_o              (VGA_G),
        .vga_b_o              (VGA_B),

        .dram_cs_no           (DRAM_CS_N),
        .dram_ras_no          (DRAM_RAS_N),
        .dram_cas_no          (DRAM_CAS_N),
        .dram_we_no           (DRAM_WE_N),
        .dram_ba_o            (DRAM_BA),
        .dram_addr_o          (DRAM_ADDR),
        .dram_dqm_o           ({DRAM_UDQM, DRAM_LDQM}),
        .dram_dq_o            (dram_dq),
        .dram_dq_oe_o         (dram_dq_oe),
        .dram_dq_i            (DRAM_DQ),

        .aud_bclk_o           (AUD_BCLK),
        .aud_daclrck_o        (AUD_DACLRCK),
        .aud_dacdat_o         (AUD_DACDAT),
        .aud_adclrck_o        (AUD_ADCLRCK),
        .aud_adcdat_i         (AUD_ADCDAT),
        .i2c_sclk_o           (FPGA_I2C_SCLK),
        .i2c_sdat_oe_o        (sdat_oe),
        .i2c_sdat_i           (FPGA_I2C_SDAT),

        .adc_convst_o         (ADC_CS_N),
        .adc_sck_o            (ADC_SCLK),
        .adc_sdi_o            (ADC_DIN),
        .adc_sdo_i            (ADC_DOUT),

        .ps2_clk_i            ({PS2_CLK2, PS2_CLK}),
        .ps2_dat_i            ({PS2_DAT2, PS2_DAT}),
        .ps2_clk_low_o        (ps2_clk_low),
        .ps2_dat_low_o        (ps2_dat_low),

        .irda_rxd_i           (IRDA_RXD),
        .irda_txd_o           (IRDA_TXD),

        .td_data_i            (TD_DATA),

        .jtag_take_i          (jtag_take),
        .jtag_sent_o          (jtag_sent),
        .jtag_sent_data_o     (jtag_sent_data),
        .jtag_room_o          (jtag_room),
        .jtag_typed_i         (jtag_typed),
        .jtag_typed_data_i    (jtag_typed_data),
        .jtag_idle_i          (jtag_idle)
    );
    // verilator lint_on PINCONNECTEMPTY

    // ---- The host's terminals, by the chip's JTAG pins ---------------------
    jtag_terminals terminals (
        .clk_i        (clk),
        .rst_i        (rst),
        .take_o       (jtag_take),
        .sent_i       (jtag_sent),
        .sent_data_i  (jtag_sent_data),
        .room_i       (jtag_room),
        .typed_o      (jtag_typed),
        .typed_data_o (jtag_typed_data),
        .idle_o       (jtag_idle)
    );
endmodule

`default_nettype wire
