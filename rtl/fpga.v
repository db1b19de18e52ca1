// fpga.v - the whole fabric: everything from the HPS bridges to the pins
//
//   lw_*  --> lw_bridge --+--> ledr hex sw key jp1 jp2 sysid
//                         +--> keypad ---- JP1 D7-D0
//                         +--> audio ----- WM8731
//                         +--> ps2 ------- keyboard
//                         +--> jtag uarts  the host's terminal
//                         +--> adc ------- LTC2308
//                         +--> irda ------ infrared receiver and LED
//                         +--> video_in -- ADV7180
//   h2f_* --> h2f_bridge -+--> video ----- ADV7123
//                         +--> sdram ----- IS42S16320D
//
// Three clock domains: 25 MHz, the pixel clock; inside audio a multiple of the sample rate; inside
// video_in the decoder's 27 MHz.  On the board de1_soc_top.v connects the bridges to the HPS and
// the pins to the package; in the simulation a TLM target does.
//
// Blocks that sleep together are a group with a clock of its own (fpga_clocks.v, SLEEP.md).

`default_nettype none

module fpga #(
    parameter ID_W = 12
) (
    input  wire            clk_i,          // 25 MHz
    input  wire            rst_i,          // synchronous, active high
    input  wire            clk_audio_i,    // 128 per sample, asynchronous to clk_i; 1.024 MHz,
    input  wire            rst_audio_i,    // or 6.144 MHz with audio_48k_i; its reset ends first
    input  wire            audio_48k_i,    // constant: 48,000 samples per second, not 8,000
    input  wire            clk_td_i,       // 27 MHz, asynchronous to both
    input  wire            rst_td_i,       // ends first, too

    // Lightweight bridge, 0xFF200000, 2 MB: AXI3, 32 bits
    input  wire [ID_W-1:0] lw_awid_i,
    input  wire [20:0]     lw_awaddr_i,
    input  wire [3:0]      lw_awlen_i,
    input  wire [2:0]      lw_awsize_i,
    input  wire [1:0]      lw_awburst_i,
    input  wire            lw_awvalid_i,
    output wire            lw_awready_o,
    input  wire [31:0]     lw_wdata_i,
    input  wire [3:0]      lw_wstrb_i,
    input  wire            lw_wvalid_i,
    output wire            lw_wready_o,
    output wire [ID_W-1:0] lw_bid_o,
    output wire [1:0]      lw_bresp_o,
    output wire            lw_bvalid_o,
    input  wire            lw_bready_i,
    input  wire [ID_W-1:0] lw_arid_i,
    input  wire [20:0]     lw_araddr_i,
    input  wire [3:0]      lw_arlen_i,
    input  wire [2:0]      lw_arsize_i,
    input  wire [1:0]      lw_arburst_i,
    input  wire            lw_arvalid_i,
    output wire            lw_arready_o,
    output wire [ID_W-1:0] lw_rid_o,
    output wire [31:0]     lw_rdata_o,
    output wire [1:0]      lw_rresp_o,
    output wire            lw_rlast_o,
    output wire            lw_rvalid_o,
    input  wire            lw_rready_i,

    // Full bridge, 0xC0000000, 1 GB: AXI3, 32 bits
    input  wire [ID_W-1:0] h2f_awid_i,
    input  wire [29:0]     h2f_awaddr_i,
    input  wire [3:0]      h2f_awlen_i,
    input  wire [2:0]      h2f_awsize_i,
    input  wire [1:0]      h2f_awburst_i,
    input  wire            h2f_awvalid_i,
    output wire            h2f_awready_o,
    input  wire [31:0]     h2f_wdata_i,
    input  wire [3:0]      h2f_wstrb_i,
    input  wire            h2f_wvalid_i,
    output wire            h2f_wready_o,
    output wire [ID_W-1:0] h2f_bid_o,
    output wire [1:0]      h2f_bresp_o,
    output wire            h2f_bvalid_o,
    input  wire            h2f_bready_i,
    input  wire [ID_W-1:0] h2f_arid_i,
    input  wire [29:0]     h2f_araddr_i,
    input  wire [3:0]      h2f_arlen_i,
    input  wire [2:0]      h2f_arsize_i,
    input  wire [1:0]      h2f_arburst_i,
    input  wire            h2f_arvalid_i,
    output wire            h2f_arready_o,
    output wire [ID_W-1:0] h2f_rid_o,
    output wire [31:0]     h2f_rdata_o,
    output wire [1:0]      h2f_rresp_o,
    output wire            h2f_rlast_o,
    output wire            h2f_rvalid_o,
    input  wire            h2f_rready_i,

    output wire [63:0]     irq_o,          // level; bit n is interrupt ID 72 + n

    // Parallel ports
    output wire [9:0]      ledr_o,
    output wire [41:0]     hex_no,         // HEX5 in 41:35 ... HEX0 in 6:0, segments g..a, 0 = lit
    input  wire [9:0]      sw_i,
    input  wire [3:0]      key_ni,         // 0 = pressed
    input  wire [31:0]     jp1_i,
    output wire [31:0]     jp1_o,
    output wire [31:0]     jp1_oe_o,
    input  wire [31:0]     jp2_i,
    output wire [31:0]     jp2_o,
    output wire [31:0]     jp2_oe_o,

    // ADV7123, whose clock is the inverted clk_i
    output wire            vga_hs_no,
    output wire            vga_vs_no,
    output wire            vga_blank_no,
    output wire            vga_sync_no,
    output wire [7:0]      vga_r_o,
    output wire [7:0]      vga_g_o,
    output wire [7:0]      vga_b_o,

    // IS42S16320D, whose clock is the inverted clk_i; CKE is 1
    output wire            dram_cs_no,
    output wire            dram_ras_no,
    output wire            dram_cas_no,
    output wire            dram_we_no,
    output wire [1:0]      dram_ba_o,
    output wire [12:0]     dram_addr_o,
    output wire [1:0]      dram_dqm_o,
    output wire [15:0]     dram_dq_o,
    output wire            dram_dq_oe_o,
    input  wire [15:0]     dram_dq_i,

    // WM8731, whose XCK of 12.288 MHz does not come from here
    output wire            aud_bclk_o,
    output wire            aud_daclrck_o,
    output wire            aud_dacdat_o,
    output wire            aud_adclrck_o,
    input  wire            aud_adcdat_i,
    output wire            i2c_sclk_o,
    output wire            i2c_sdat_oe_o,  // 1 = pull low
    input  wire            i2c_sdat_i,

    // LTC2308
    output wire            adc_convst_o,
    output wire            adc_sck_o,
    output wire            adc_sdi_o,
    input  wire            adc_sdo_i,

    // PS/2, bit n of port n
    input  wire [1:0]      ps2_clk_i,
    input  wire [1:0]      ps2_dat_i,
    output wire [1:0]      ps2_clk_low_o,  // 1 = pull low
    output wire [1:0]      ps2_dat_low_o,

    // Infrared
    input  wire            irda_rxd_i,     // high while it is dark
    output wire            irda_txd_o,     // 1 = light

    // ADV7180; its HS and VS are redundant, so not connected
    input  wire [7:0]      td_data_i,      // of clk_td_i

    // Host's side of the JTAG UARTs, bit or byte n of number n: see jtag_uart.v
    input  wire [1:0]      jtag_take_i,
    output wire [1:0]      jtag_sent_o,
    output wire [15:0]     jtag_sent_data_o,
    output wire [1:0]      jtag_room_o,
    input  wire [1:0]      jtag_typed_i,
    input  wire [15:0]     jtag_typed_data_i,
    input  wire [1:0]      jtag_idle_i
);
    `include "regmap.vh"

    // ---- Clocks, and who sleeps -------------------------------------------
    wire clk, lw_clk, h2f_clk, memory_clk, ports_clk, audio_clk;
    wire lw_awake, h2f_awake, cells_awake, sdram_awake, turns_awake, fetch_awake, audio_awake;
    wire parallel_awake, sysid_awake, keypad_awake, timer0_awake, timer1_awake, jtag_awake;
    wire adc_awake, ps2_awake, screen_awake, irda_awake, video_in_awake, td_awake;
    wire frame_end, cells_clear, cell_fetch;

    wire ports_awake = parallel_awake || sysid_awake || keypad_awake || timer0_awake
                       || timer1_awake || jtag_awake || adc_awake || ps2_awake || screen_awake
                       || irda_awake || video_in_awake;

    fpga_clocks clocks (
        .clk_i(clk_i), .rst_i(rst_i),
        .lw_awake_i(lw_awake),
        .h2f_awake_i(h2f_awake || cells_awake || cells_clear || cell_fetch),
        .memory_awake_i(onchip_we != 4'd0 || onchip_re || sdram_awake || sdram_req || turns_awake),
        .fetch_awake_i(fetch_awake),
        .audio_awake_i(audio_awake || audio_we || audio_re),
        .ports_awake_i(ports_awake || we != 32'd0 || re != 32'd0 || frame_end),
        .td_awake_i(td_awake),
        .clk_o(clk), .lw_clk_o(lw_clk), .h2f_clk_o(h2f_clk), .memory_clk_o(memory_clk),
        .ports_clk_o(ports_clk), .audio_clk_o(audio_clk)
    );

    // ---- Bridges ----------------------------------------------------------
    wire [31:0] we, re;
    wire [11:0] waddr, raddr;
    wire [31:0] wdata;
    wire [3:0]  wstrb;
    wire        rlow, ps2_wait, audio_hold, adc_hold;
    wire [31:0] ports_rdata, sysid_rdata, vga_rdata, audio_rdata, keypad_rdata, timer0_rdata;
    wire [31:0] timer1_rdata, jtag_rdata, ps2_rdata, adc_rdata, irda_rdata;
    wire [31:0] video_in_rdata;

    lw_bridge #(.ID_W(ID_W)) lw (
        .clk_i(lw_clk), .rst_i(rst_i),
        .awid_i(lw_awid_i), .awaddr_i(lw_awaddr_i), .awlen_i(lw_awlen_i), .awsize_i(lw_awsize_i),
        .awburst_i(lw_awburst_i), .awvalid_i(lw_awvalid_i), .awready_o(lw_awready_o),
        .wdata_i(lw_wdata_i), .wstrb_i(lw_wstrb_i), .wvalid_i(lw_wvalid_i), .wready_o(lw_wready_o),
        .bid_o(lw_bid_o), .bresp_o(lw_bresp_o), .bvalid_o(lw_bvalid_o), .bready_i(lw_bready_i),
        .arid_i(lw_arid_i), .araddr_i(lw_araddr_i), .arlen_i(lw_arlen_i), .arsize_i(lw_arsize_i),
        .arburst_i(lw_arburst_i), .arvalid_i(lw_arvalid_i), .arready_o(lw_arready_o),
        .rid_o(lw_rid_o), .rdata_o(lw_rdata_o), .rresp_o(lw_rresp_o), .rlast_o(lw_rlast_o),
        .rvalid_o(lw_rvalid_o), .rready_i(lw_rready_i),
        .we_o(we), .waddr_o(waddr), .wdata_o(wdata), .wstrb_o(wstrb),
        .hold_i(ps2_wait || audio_hold),
        .re_o(re), .raddr_o(raddr), .rlow_o(rlow), .rhold_i(adc_hold),
        .rdata_i(ports_rdata | sysid_rdata | vga_rdata | audio_rdata | keypad_rdata
                 | timer0_rdata | timer1_rdata | jtag_rdata | ps2_rdata | adc_rdata
                 | irda_rdata | video_in_rdata),
        .awake_o(lw_awake)
    );

    wire [3:0]  onchip_we, cells_we, sdram_wstrb;
    wire        onchip_re, onchip_grant, cells_wait;
    wire [15:0] onchip_windex, onchip_rindex;
    wire [31:0] onchip_wdata, onchip_rdata, cells_rdata;
    wire        sdram_req, sdram_we, sdram_take, sdram_valid;
    wire [23:0] sdram_index, screen_index;
    wire [31:0] sdram_wdata, sdram_rdata;
    wire        screen_req, screen_take, screen_valid;

    h2f_bridge #(.ID_W(ID_W)) h2f (
        .clk_i(h2f_clk), .rst_i(rst_i),
        .awid_i(h2f_awid_i), .awaddr_i(h2f_awaddr_i), .awlen_i(h2f_awlen_i),
        .awsize_i(h2f_awsize_i), .awburst_i(h2f_awburst_i), .awvalid_i(h2f_awvalid_i),
        .awready_o(h2f_awready_o),
        .wdata_i(h2f_wdata_i), .wstrb_i(h2f_wstrb_i), .wvalid_i(h2f_wvalid_i),
        .wready_o(h2f_wready_o),
        .bid_o(h2f_bid_o), .bresp_o(h2f_bresp_o), .bvalid_o(h2f_bvalid_o), .bready_i(h2f_bready_i),
        .arid_i(h2f_arid_i), .araddr_i(h2f_araddr_i), .arlen_i(h2f_arlen_i),
        .arsize_i(h2f_arsize_i), .arburst_i(h2f_arburst_i), .arvalid_i(h2f_arvalid_i),
        .arready_o(h2f_arready_o),
        .rid_o(h2f_rid_o), .rdata_o(h2f_rdata_o), .rresp_o(h2f_rresp_o), .rlast_o(h2f_rlast_o),
        .rvalid_o(h2f_rvalid_o), .rready_i(h2f_rready_i),
        .we_o(onchip_we), .cell_we_o(cells_we), .windex_o(onchip_windex), .wdata_o(onchip_wdata),
        .re_o(onchip_re), .rindex_o(onchip_rindex), .rgrant_i(onchip_grant),
        .rdata_i(onchip_rdata), .cells_i(cells_rdata), .cells_wait_i(cells_wait),
        .sdram_req_o(sdram_req), .sdram_we_o(sdram_we), .sdram_index_o(sdram_index),
        .sdram_wdata_o(sdram_wdata), .sdram_wstrb_o(sdram_wstrb), .sdram_take_i(sdram_take),
        .sdram_valid_i(sdram_valid), .sdram_i(sdram_rdata),
        .awake_o(h2f_awake)
    );

    // ---- SDRAM, and what video-in writes to the memories ------------------
    wire [3:0]  chip_we, dram_wstrb;
    wire [15:0] chip_windex;
    wire [31:0] chip_wdata, dram_wdata, camera_wdata;
    wire [23:0] dram_index, camera_index;
    wire        dram_req, dram_we, dram_take;
    wire        camera_onchip, camera_onchip_take, camera_sdram, camera_sdram_take;

    write_turns turns (
        .clk_i(memory_clk), .rst_i(rst_i),
        .onchip_busy_i(onchip_we != 4'd0 || cells_we != 4'd0), .onchip_we_i(onchip_we),
        .onchip_windex_i(onchip_windex), .onchip_wdata_i(onchip_wdata),
        .req_i(sdram_req), .we_i(sdram_we), .index_i(sdram_index), .wdata_i(sdram_wdata),
        .wstrb_i(sdram_wstrb), .take_o(sdram_take),
        .video_onchip_i(camera_onchip), .video_onchip_take_o(camera_onchip_take),
        .video_sdram_i(camera_sdram), .video_sdram_take_o(camera_sdram_take),
        .video_index_i(camera_index), .video_wdata_i(camera_wdata),
        .onchip_we_o(chip_we), .onchip_windex_o(chip_windex), .onchip_wdata_o(chip_wdata),
        .sdram_req_o(dram_req), .sdram_we_o(dram_we), .sdram_index_o(dram_index),
        .sdram_wdata_o(dram_wdata), .sdram_wstrb_o(dram_wstrb), .sdram_take_i(dram_take),
        .awake_o(turns_awake)
    );

    sdram sdram_block (
        .clk_i(memory_clk), .rst_i(rst_i),
        .screen_req_i(screen_req), .screen_index_i(screen_index), .screen_take_o(screen_take),
        .screen_valid_o(screen_valid),
        .req_i(dram_req), .we_i(dram_we), .index_i(dram_index), .wdata_i(dram_wdata),
        .wstrb_i(dram_wstrb), .take_o(dram_take), .valid_o(sdram_valid), .rdata_o(sdram_rdata),
        .dram_cs_no(dram_cs_no), .dram_ras_no(dram_ras_no), .dram_cas_no(dram_cas_no),
        .dram_we_no(dram_we_no), .dram_ba_o(dram_ba_o), .dram_addr_o(dram_addr_o),
        .dram_dqm_o(dram_dqm_o), .dram_dq_o(dram_dq_o), .dram_dq_oe_o(dram_dq_oe_o),
        .dram_dq_i(dram_dq_i),
        .awake_o(sdram_awake)
    );

    // ---- Parallel ports ---------------------------------------------------
    wire        keypad_enable, key_irq, jp1_irq, jp2_irq, keypad_irq, audio_irq;
    wire [3:0]  keypad_col_low;
    wire [31:0] jp1_out, jp1_oe;

    parallel_ports ports (
        .clk_i(ports_clk), .rst_i(rst_i), .we_i(we), .wstrb_i(wstrb),
        .waddr_i(waddr), .wdata_i(wdata), .re_i(re), .raddr_i(raddr),
        .rdata_o(ports_rdata), .key_irq_o(key_irq), .jp1_irq_o(jp1_irq), .jp2_irq_o(jp2_irq),
        .ledr_o(ledr_o), .hex_no(hex_no), .sw_i(sw_i), .key_ni(key_ni),
        .jp1_i(jp1_i), .jp1_o(jp1_out), .jp1_oe_o(jp1_oe),
        .jp2_i(jp2_i), .jp2_o(jp2_o), .jp2_oe_o(jp2_oe_o),
        .awake_o(parallel_awake)
    );
    sysid sysid_block (
        .clk_i(ports_clk), .re_i(re[SEL_SYSID]), .raddr_i(raddr), .rdata_o(sysid_rdata),
        .awake_o(sysid_awake)
    );

    // ---- Keypad: columns on JP1 D7 (left) to D4, rows on D3 (top) to D0 -----
    keypad keypad_block (
        .clk_i(ports_clk), .rst_i(rst_i), .we_i(we[SEL_KEYPAD]),
        .wstrb_i(wstrb), .waddr_i(waddr), .wdata_i(wdata), .re_i(re[SEL_KEYPAD]), .raddr_i(raddr),
        .rdata_o(keypad_rdata),
        .irq_o(keypad_irq), .enable_o(keypad_enable), .col_low_o(keypad_col_low),
        .row_ni({jp1_i[0], jp1_i[1], jp1_i[2], jp1_i[3]}),
        .awake_o(keypad_awake)
    );

    assign jp1_o    = {jp1_out[31:8], keypad_enable ? 8'h00 : jp1_out[7:0]};
    assign jp1_oe_o = {jp1_oe[31:8], keypad_enable
                       ? {keypad_col_low[0], keypad_col_low[1], keypad_col_low[2],
                          keypad_col_low[3], 4'd0}
                       : jp1_oe[7:0]};

    // ---- Video and audio --------------------------------------------------
    video video_block (
        .clk_i(clk), .registers_clk_i(ports_clk), .memory_clk_i(memory_clk), .cells_clk_i(h2f_clk),
        .rst_i(rst_i), .we_i(we[SEL_PIXEL]), .wstrb_i(wstrb), .waddr_i(waddr),
        .wdata_i(wdata), .re_i(re[SEL_PIXEL]), .resampler_re_i(re[SEL_RESAMPLER]),
        .text_we_i(we[SEL_TEXT]), .text_re_i(re[SEL_TEXT]), .raddr_i(raddr), .rdata_o(vga_rdata),
        .onchip_we_i(chip_we), .cells_we_i(cells_we), .windex_i(chip_windex),
        .onchip_i(chip_wdata), .onchip_re_i(onchip_re), .rindex_i(onchip_rindex),
        .rgrant_o(onchip_grant), .onchip_o(onchip_rdata), .cells_o(cells_rdata),
        .cells_wait_o(cells_wait),
        .sdram_req_o(screen_req), .sdram_index_o(screen_index), .sdram_take_i(screen_take),
        .sdram_valid_i(screen_valid), .sdram_i(sdram_rdata),
        .vga_hs_no(vga_hs_no), .vga_vs_no(vga_vs_no),
        .vga_blank_no(vga_blank_no), .vga_sync_no(vga_sync_no),
        .vga_r_o(vga_r_o), .vga_g_o(vga_g_o), .vga_b_o(vga_b_o),
        .registers_awake_o(screen_awake), .cells_awake_o(cells_awake),
        .frame_end_o(frame_end), .cells_clear_o(cells_clear), .cell_fetch_o(cell_fetch),
        .fetch_awake_o(fetch_awake)
    );

    wire audio_we = we[SEL_AUDIO] || we[SEL_AV_CONFIG] || we[SEL_CODEC];
    wire audio_re = re[SEL_AUDIO] || re[SEL_AV_CONFIG] || re[SEL_CODEC];

    audio audio_block (
        .clk_i(audio_clk), .rst_i(rst_i), .clk_audio_i(clk_audio_i), .rst_audio_i(rst_audio_i),
        .fast_i(audio_48k_i),
        .we_i(audio_we), .wstrb_i(wstrb), .waddr_i(waddr), .wdata_i(wdata), .re_i(audio_re),
        .raddr_i(raddr), .rdata_o(audio_rdata), .hold_o(audio_hold), .irq_o(audio_irq),
        .aud_bclk_o(aud_bclk_o), .aud_daclrck_o(aud_daclrck_o), .aud_dacdat_o(aud_dacdat_o),
        .aud_adclrck_o(aud_adclrck_o), .aud_adcdat_i(aud_adcdat_i),
        .i2c_sclk_o(i2c_sclk_o), .i2c_sdat_oe_o(i2c_sdat_oe_o), .i2c_sdat_i(i2c_sdat_i),
        .awake_o(audio_awake)
    );

    // ---- Interval timers --------------------------------------------------
    wire timer0_irq, timer1_irq;

    interval_timer timer0 (
        .clk_i(ports_clk), .rst_i(rst_i), .we_i(we[SEL_TIMER0]),
        .wstrb_i(wstrb), .waddr_i(waddr), .wdata_i(wdata), .re_i(re[SEL_TIMER0]), .raddr_i(raddr),
        .rdata_o(timer0_rdata),
        .irq_o(timer0_irq),
        .awake_o(timer0_awake)
    );
    interval_timer timer1 (
        .clk_i(ports_clk), .rst_i(rst_i), .we_i(we[SEL_TIMER1]),
        .wstrb_i(wstrb), .waddr_i(waddr), .wdata_i(wdata), .re_i(re[SEL_TIMER1]), .raddr_i(raddr),
        .rdata_o(timer1_rdata),
        .irq_o(timer1_irq),
        .awake_o(timer1_awake)
    );

    // ---- JTAG UARTs -------------------------------------------------------
    wire [1:0] jtag_irq;

    jtag_uarts jtag (
        .clk_i(ports_clk), .rst_i(rst_i),
        .we_i({we[SEL_JTAG_UART1], we[SEL_JTAG_UART0]}), .wstrb_i(wstrb), .waddr_i(waddr),
        .wdata_i(wdata), .re_i({re[SEL_JTAG_UART1], re[SEL_JTAG_UART0]}), .raddr_i(raddr),
        .rdata_o(jtag_rdata), .irq_o(jtag_irq),
        .take_i(jtag_take_i), .sent_o(jtag_sent_o), .sent_data_o(jtag_sent_data_o),
        .room_o(jtag_room_o), .typed_i(jtag_typed_i), .typed_data_i(jtag_typed_data_i),
        .idle_i(jtag_idle_i),
        .awake_o(jtag_awake)
    );

    // ---- AD converter -----------------------------------------------------
    adc adc_block (
        .clk_i(ports_clk), .rst_i(rst_i), .we_i(we[SEL_ADC]), .wstrb_i(wstrb), .waddr_i(waddr),
        .wdata_i(wdata), .re_i(re[SEL_ADC]), .raddr_i(raddr), .rdata_o(adc_rdata),
        .rhold_o(adc_hold),
        .convst_o(adc_convst_o), .sck_o(adc_sck_o), .sdi_o(adc_sdi_o), .sdo_i(adc_sdo_i),
        .awake_o(adc_awake)
    );

    // ---- PS/2 -------------------------------------------------------------
    wire [1:0] ps2_irq;

    ps2_ports ps2 (
        .clk_i(ports_clk), .rst_i(rst_i),
        .we_i({we[SEL_PS2_1], we[SEL_PS2_0]}), .wstrb_i(wstrb), .waddr_i(waddr), .wdata_i(wdata),
        .re_i({re[SEL_PS2_1], re[SEL_PS2_0]}), .rlow_i(rlow), .raddr_i(raddr),
        .rdata_o(ps2_rdata), .wait_o(ps2_wait), .irq_o(ps2_irq),
        .ps2_clk_i(ps2_clk_i), .ps2_dat_i(ps2_dat_i),
        .ps2_clk_low_o(ps2_clk_low_o), .ps2_dat_low_o(ps2_dat_low_o),
        .awake_o(ps2_awake)
    );

    // ---- Infrared ---------------------------------------------------------
    wire irda_irq;

    irda irda_block (
        .clk_i(ports_clk), .rst_i(rst_i), .we_i(we[SEL_IRDA]), .wstrb_i(wstrb), .waddr_i(waddr),
        .wdata_i(wdata), .re_i(re[SEL_IRDA]), .rlow_i(rlow), .raddr_i(raddr),
        .rdata_o(irda_rdata), .irq_o(irda_irq), .rxd_i(irda_rxd_i), .txd_o(irda_txd_o),
        .awake_o(irda_awake)
    );

    // ---- Video in ---------------------------------------------------------
    video_in video_in_block (
        .clk_i(ports_clk), .rst_i(rst_i), .clk_td_i(clk_td_i), .rst_td_i(rst_td_i),
        .td_data_i(td_data_i),
        .we_i(we[SEL_VIDEO_IN]), .edges_we_i(we[SEL_EDGE_DETECTION]), .wstrb_i(wstrb),
        .waddr_i(waddr), .wdata_i(wdata), .re_i(re[SEL_VIDEO_IN]),
        .edges_re_i(re[SEL_EDGE_DETECTION]), .raddr_i(raddr), .rdata_o(video_in_rdata),
        .onchip_req_o(camera_onchip), .onchip_take_i(camera_onchip_take),
        .sdram_req_o(camera_sdram), .sdram_take_i(camera_sdram_take),
        .index_o(camera_index), .wdata_o(camera_wdata),
        .awake_o(video_in_awake), .td_awake_o(td_awake)
    );

    // ---- Interrupts -------------------------------------------------------
    assign irq_o = {63'd0, key_irq} << KEY_IRQ | {63'd0, audio_irq} << AUDIO_IRQ
                   | {63'd0, jp1_irq} << JP1_IRQ | {63'd0, jp2_irq} << JP2_IRQ
                   | {63'd0, keypad_irq} << KEYPAD_IRQ | {63'd0, timer0_irq} << TIMER0_IRQ
                   | {63'd0, timer1_irq} << TIMER1_IRQ | {63'd0, irda_irq} << IRDA_IRQ
                   | {63'd0, jtag_irq[0]} << JTAG_UART0_IRQ
                   | {63'd0, jtag_irq[1]} << JTAG_UART1_IRQ
                   | {63'd0, ps2_irq[0]} << PS2_0_IRQ | {63'd0, ps2_irq[1]} << PS2_1_IRQ;
endmodule

`default_nettype wire
