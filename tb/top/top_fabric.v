// top_fabric.v - the whole chip of the board, de1_soc_top.v, behind the ports of fpga.v
//
//   ports --> primitives.v --> clocks, the processor's bridges, the host's terminals --> chip
//   ports <-- pins, tri-state ones as the board resolves them <-------------------------
//
// So sim/fpga/fabric.cpp runs it as it runs fpga.v, and the same files come out.  Whether the chip
// drives a tri-state pin cannot be seen at the pin: this is read inside, the level at the pin.
//
// Not handled: 48,000 samples per second, which is a parameter of the chip; the resets of the
// ports, since the chip has its own.

`default_nettype none

// verilator lint_off UNUSED

module top_fabric (
    input  wire        clk_i, rst_i, clk_audio_i, rst_audio_i, audio_48k_i, clk_td_i, rst_td_i,

    input  wire [11:0] lw_awid_i, lw_arid_i,
    input  wire [20:0] lw_awaddr_i, lw_araddr_i,
    input  wire [3:0]  lw_awlen_i, lw_wstrb_i, lw_arlen_i,
    input  wire [2:0]  lw_awsize_i, lw_arsize_i,
    input  wire [1:0]  lw_awburst_i, lw_arburst_i,
    input  wire        lw_awvalid_i, lw_wvalid_i, lw_bready_i, lw_arvalid_i, lw_rready_i,
    output wire        lw_awready_o, lw_wready_o, lw_bvalid_o, lw_arready_o, lw_rlast_o,
                       lw_rvalid_o,
    input  wire [31:0] lw_wdata_i,
    output wire [11:0] lw_bid_o, lw_rid_o,
    output wire [1:0]  lw_bresp_o, lw_rresp_o,
    output wire [31:0] lw_rdata_o,

    input  wire [11:0] h2f_awid_i, h2f_arid_i,
    input  wire [29:0] h2f_awaddr_i, h2f_araddr_i,
    input  wire [3:0]  h2f_awlen_i, h2f_wstrb_i, h2f_arlen_i,
    input  wire [2:0]  h2f_awsize_i, h2f_arsize_i,
    input  wire [1:0]  h2f_awburst_i, h2f_arburst_i,
    input  wire        h2f_awvalid_i, h2f_wvalid_i, h2f_bready_i, h2f_arvalid_i, h2f_rready_i,
    output wire        h2f_awready_o, h2f_wready_o, h2f_bvalid_o, h2f_arready_o, h2f_rlast_o,
                       h2f_rvalid_o,
    input  wire [31:0] h2f_wdata_i,
    output wire [11:0] h2f_bid_o, h2f_rid_o,
    output wire [1:0]  h2f_bresp_o, h2f_rresp_o,
    output wire [31:0] h2f_rdata_o,

    output wire [31:0] irq_o,

    output wire [9:0]  ledr_o,
    output wire [41:0] hex_no,
    input  wire [9:0]  sw_i,
    input  wire [3:0]  key_ni,
    input  wire [31:0] jp1_i, jp2_i,
    output wire [31:0] jp1_o, jp1_oe_o, jp2_o, jp2_oe_o,

    output wire        vga_hs_no, vga_vs_no, vga_blank_no, vga_sync_no,
    output wire [7:0]  vga_r_o, vga_g_o, vga_b_o,

    output wire        dram_cs_no, dram_ras_no, dram_cas_no, dram_we_no, dram_dq_oe_o,
    output wire [1:0]  dram_ba_o, dram_dqm_o,
    output wire [12:0] dram_addr_o,
    output wire [15:0] dram_dq_o,
    input  wire [15:0] dram_dq_i,

    output wire        aud_bclk_o, aud_daclrck_o, aud_dacdat_o, aud_adclrck_o, i2c_sclk_o,
                       i2c_sdat_oe_o,
    input  wire        aud_adcdat_i, i2c_sdat_i,

    output wire        adc_convst_o, adc_sck_o, adc_sdi_o,
    input  wire        adc_sdo_i,

    input  wire [1:0]  ps2_clk_i, ps2_dat_i,
    output wire [1:0]  ps2_clk_low_o, ps2_dat_low_o,

    input  wire        irda_rxd_i,
    output wire        irda_txd_o,

    input  wire [7:0]  td_data_i,

    input  wire [1:0]  jtag_take_i, jtag_typed_i, jtag_idle_i,
    output wire [1:0]  jtag_sent_o, jtag_room_o,
    output wire [15:0] jtag_sent_data_o,
    input  wire [15:0] jtag_typed_data_i
);
    // ---- The board's wires ------------------------------------------------
    wire [35:0] GPIO_0, GPIO_1;
    wire [15:0] DRAM_DQ;
    wire        FPGA_I2C_SDAT, PS2_CLK, PS2_DAT, PS2_CLK2, PS2_DAT2;

    // A header's pins by its port's bits; the four others are pulled up.
    function [35:0] pins;
        input [31:0] bits;
        input        others;
        pins = {bits[31:15], others, bits[14], others, bits[13:1], others, bits[0], others};
    endfunction
    wire [35:0] outside_0 = pins(jp1_i, 1'b1), inside_0 = pins(jp1_oe_o, 1'b0);
    wire [35:0] outside_1 = pins(jp2_i, 1'b1), inside_1 = pins(jp2_oe_o, 1'b0);

    genvar n;
    generate
        for (n = 0; n < 36; n = n + 1) begin : header
            assign GPIO_0[n] = inside_0[n] ? 1'bz : outside_0[n];
            assign GPIO_1[n] = inside_1[n] ? 1'bz : outside_1[n];
        end
    endgenerate

    assign jp1_oe_o = chip.jp1_oe;
    assign jp2_oe_o = chip.jp2_oe;
    assign jp1_o = {GPIO_0[35:19], GPIO_0[17], GPIO_0[15:3], GPIO_0[1]} & jp1_oe_o;
    assign jp2_o = {GPIO_1[35:19], GPIO_1[17], GPIO_1[15:3], GPIO_1[1]} & jp2_oe_o;

    assign DRAM_DQ = dram_dq_oe_o ? 16'bz : dram_dq_i;
    assign dram_dq_oe_o = chip.dram_dq_oe;
    assign dram_dq_o = DRAM_DQ;

    // Open drains with pull-ups: each side drives 0 or nothing.
    assign FPGA_I2C_SDAT = chip.sdat_oe || i2c_sdat_i ? 1'bz : 1'b0;
    assign PS2_CLK  = chip.ps2_clk_low[0] || ps2_clk_i[0] ? 1'bz : 1'b0;
    assign PS2_CLK2 = chip.ps2_clk_low[1] || ps2_clk_i[1] ? 1'bz : 1'b0;
    assign PS2_DAT  = chip.ps2_dat_low[0] || ps2_dat_i[0] ? 1'bz : 1'b0;
    assign PS2_DAT2 = chip.ps2_dat_low[1] || ps2_dat_i[1] ? 1'bz : 1'b0;
    pullup (FPGA_I2C_SDAT);
    pullup (PS2_CLK);
    pullup (PS2_CLK2);
    pullup (PS2_DAT);
    pullup (PS2_DAT2);
    assign i2c_sdat_oe_o = chip.sdat_oe && !FPGA_I2C_SDAT;
    assign ps2_clk_low_o = chip.ps2_clk_low & ~{PS2_CLK2, PS2_CLK};
    assign ps2_dat_low_o = chip.ps2_dat_low & ~{PS2_DAT2, PS2_DAT};

    // ---- The chip ---------------------------------------------------------
    wire        VGA_CLK, DRAM_CLK, DRAM_CKE, AUD_XCK, TD_RESET_N;

    de1_soc_top chip (
        .CLOCK_50(clk_i), .KEY(key_ni), .SW(sw_i), .LEDR(ledr_o),
        .HEX0(hex_no[6:0]), .HEX1(hex_no[13:7]), .HEX2(hex_no[20:14]), .HEX3(hex_no[27:21]),
        .HEX4(hex_no[34:28]), .HEX5(hex_no[41:35]),
        .GPIO_0(GPIO_0), .GPIO_1(GPIO_1),
        .VGA_CLK(VGA_CLK), .VGA_HS(vga_hs_no), .VGA_VS(vga_vs_no), .VGA_BLANK_N(vga_blank_no),
        .VGA_SYNC_N(vga_sync_no), .VGA_R(vga_r_o), .VGA_G(vga_g_o), .VGA_B(vga_b_o),
        .DRAM_CLK(DRAM_CLK), .DRAM_CKE(DRAM_CKE), .DRAM_CS_N(dram_cs_no), .DRAM_RAS_N(dram_ras_no),
        .DRAM_CAS_N(dram_cas_no), .DRAM_WE_N(dram_we_no), .DRAM_BA(dram_ba_o),
        .DRAM_ADDR(dram_addr_o), .DRAM_LDQM(dram_dqm_o[0]), .DRAM_UDQM(dram_dqm_o[1]),
        .DRAM_DQ(DRAM_DQ),
        .AUD_XCK(AUD_XCK), .AUD_BCLK(aud_bclk_o), .AUD_DACLRCK(aud_daclrck_o),
        .AUD_DACDAT(aud_dacdat_o), .AUD_ADCLRCK(aud_adclrck_o), .AUD_ADCDAT(aud_adcdat_i),
        .FPGA_I2C_SCLK(i2c_sclk_o), .FPGA_I2C_SDAT(FPGA_I2C_SDAT),
        .ADC_CS_N(adc_convst_o), .ADC_SCLK(adc_sck_o), .ADC_DIN(adc_sdi_o), .ADC_DOUT(adc_sdo_i),
        .PS2_CLK(PS2_CLK), .PS2_DAT(PS2_DAT), .PS2_CLK2(PS2_CLK2), .PS2_DAT2(PS2_DAT2),
        .IRDA_RXD(irda_rxd_i), .IRDA_TXD(irda_txd_o),
        .TD_CLK27(clk_td_i), .TD_DATA(td_data_i), .TD_RESET_N(TD_RESET_N)
    );

    // ---- The processor and the host get back what reaches the primitives ----
    assign lw_awready_o  = chip.hps.lightweight.awready;
    assign lw_wready_o   = chip.hps.lightweight.wready;
    assign lw_bid_o      = chip.hps.lightweight.bid;
    assign lw_bresp_o    = chip.hps.lightweight.bresp;
    assign lw_bvalid_o   = chip.hps.lightweight.bvalid;
    assign lw_arready_o  = chip.hps.lightweight.arready;
    assign lw_rid_o      = chip.hps.lightweight.rid;
    assign lw_rdata_o    = chip.hps.lightweight.rdata;
    assign lw_rresp_o    = chip.hps.lightweight.rresp;
    assign lw_rlast_o    = chip.hps.lightweight.rlast;
    assign lw_rvalid_o   = chip.hps.lightweight.rvalid;
    assign h2f_awready_o = chip.hps.full.awready;
    assign h2f_wready_o  = chip.hps.full.wready;
    assign h2f_bid_o     = chip.hps.full.bid;
    assign h2f_bresp_o   = chip.hps.full.bresp;
    assign h2f_bvalid_o  = chip.hps.full.bvalid;
    assign h2f_arready_o = chip.hps.full.arready;
    assign h2f_rid_o     = chip.hps.full.rid;
    assign h2f_rdata_o   = chip.hps.full.rdata;
    assign h2f_rresp_o   = chip.hps.full.rresp;
    assign h2f_rlast_o   = chip.hps.full.rlast;
    assign h2f_rvalid_o  = chip.hps.full.rvalid;
    assign irq_o = chip.hps.interrupts.irq[31:0];
    assign jtag_sent_o = {chip.terminals.terminal[1].atlantic.r_val,
                          chip.terminals.terminal[0].atlantic.r_val};
    assign jtag_sent_data_o = {chip.terminals.terminal[1].atlantic.r_dat,
                               chip.terminals.terminal[0].atlantic.r_dat};
    assign jtag_room_o = {chip.terminals.terminal[1].atlantic.t_dav,
                          chip.terminals.terminal[0].atlantic.t_dav};
endmodule

`default_nettype wire
