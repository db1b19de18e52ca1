// hps.v - the hard processor system as the fabric sees it: two AXI masters, a reset, interrupts
//
// Cyclone V primitives (Cyclone V Device Handbook, volume 3, HPS-FPGA bridges).  Both bridges run
// on the fabric's clock; the full one is 32 bits wide (port_size_config 0).  f2h_irq[n] is
// interrupt ID 72 + n.  The boot loader sets up pins, clocks and DDR3 of the HPS.
//
// Not handled: the FPGA-to-HPS bridge and the FPGA's ports to DDR3, which are switched off.

`default_nettype none

module hps #(
    parameter ID_W = 12
) (
    input  wire            clk_i,
    output wire            rst_no,        // asynchronous; low while the HPS is in reset
    input  wire [63:0]     irq_i,

    // Lightweight bridge
    output wire [ID_W-1:0] lw_awid_o,
    output wire [20:0]     lw_awaddr_o,
    output wire [3:0]      lw_awlen_o,
    output wire [2:0]      lw_awsize_o,
    output wire [1:0]      lw_awburst_o,
    output wire            lw_awvalid_o,
    input  wire            lw_awready_i,
    output wire [31:0]     lw_wdata_o,
    output wire [3:0]      lw_wstrb_o,
    output wire            lw_wvalid_o,
    input  wire            lw_wready_i,
    input  wire [ID_W-1:0] lw_bid_i,
    input  wire [1:0]      lw_bresp_i,
    input  wire            lw_bvalid_i,
    output wire            lw_bready_o,
    output wire [ID_W-1:0] lw_arid_o,
    output wire [20:0]     lw_araddr_o,
    output wire [3:0]      lw_arlen_o,
    output wire [2:0]      lw_arsize_o,
    output wire [1:0]      lw_arburst_o,
    output wire            lw_arvalid_o,
    input  wire            lw_arready_i,
    input  wire [ID_W-1:0] lw_rid_i,
    input  wire [31:0]     lw_rdata_i,
    input  wire [1:0]      lw_rresp_i,
    input  wire            lw_rlast_i,
    input  wire            lw_rvalid_i,
    output wire            lw_rready_o,

    // Full bridge
    output wire [ID_W-1:0] h2f_awid_o,
    output wire [29:0]     h2f_awaddr_o,
    output wire [3:0]      h2f_awlen_o,
    output wire [2:0]      h2f_awsize_o,
    output wire [1:0]      h2f_awburst_o,
    output wire            h2f_awvalid_o,
    input  wire            h2f_awready_i,
    output wire [31:0]     h2f_wdata_o,
    output wire [3:0]      h2f_wstrb_o,
    output wire            h2f_wvalid_o,
    input  wire            h2f_wready_i,
    input  wire [ID_W-1:0] h2f_bid_i,
    input  wire [1:0]      h2f_bresp_i,
    input  wire            h2f_bvalid_i,
    output wire            h2f_bready_o,
    output wire [ID_W-1:0] h2f_arid_o,
    output wire [29:0]     h2f_araddr_o,
    output wire [3:0]      h2f_arlen_o,
    output wire [2:0]      h2f_arsize_o,
    output wire [1:0]      h2f_arburst_o,
    output wire            h2f_arvalid_o,
    input  wire            h2f_arready_i,
    input  wire [ID_W-1:0] h2f_rid_i,
    input  wire [31:0]     h2f_rdata_i,
    input  wire [1:0]      h2f_rresp_i,
    input  wire            h2f_rlast_i,
    input  wire            h2f_rvalid_i,
    output wire            h2f_rready_o
);
    cyclonev_hps_interface_clocks_resets clocks_resets (
        .h2f_rst_n           (rst_no),
        .f2h_cold_rst_req_n  (1'b1),
        .f2h_warm_rst_req_n  (1'b1),
        .f2h_dbg_rst_req_n   (1'b1),
        .f2h_pending_rst_ack (1'b1)
    );

    cyclonev_hps_interface_interrupts interrupts (.irq(irq_i));

    // ---- Bridges ----------------------------------------------------------
    // The fabric's slaves ignore locks, caches, protection and write IDs.
    // verilator lint_off PINCONNECTEMPTY
    cyclonev_hps_interface_hps2fpga_light_weight lightweight (
        .clk     (clk_i),
        .awid    (lw_awid_o),
        .awaddr  (lw_awaddr_o),
        .awlen   (lw_awlen_o),
        .awsize  (lw_awsize_o),
        .awburst (lw_awburst_o),
        .awvalid (lw_awvalid_o),
        .awready (lw_awready_i),
        .wdata   (lw_wdata_o),
        .wstrb   (lw_wstrb_o),
        .wvalid  (lw_wvalid_o),
        .wready  (lw_wready_i),
        .bid     (lw_bid_i),
        .bresp   (lw_bresp_i),
        .bvalid  (lw_bvalid_i),
        .bready  (lw_bready_o),
        .arid    (lw_arid_o),
        .araddr  (lw_araddr_o),
        .arlen   (lw_arlen_o),
        .arsize  (lw_arsize_o),
        .arburst (lw_arburst_o),
        .arvalid (lw_arvalid_o),
        .arready (lw_arready_i),
        .rid     (lw_rid_i),
        .rdata   (lw_rdata_i),
        .rresp   (lw_rresp_i),
        .rlast   (lw_rlast_i),
        .rvalid  (lw_rvalid_i),
        .rready  (lw_rready_o),
        .awlock  (),
        .awcache (),
        .awprot  (),
        .wid     (),
        .wlast   (),
        .arlock  (),
        .arcache (),
        .arprot  ()
    );

    cyclonev_hps_interface_hps2fpga full (
        .clk     (clk_i),
        .port_size_config (2'b00),   // 32 bits
        .awid    (h2f_awid_o),
        .awaddr  (h2f_awaddr_o),
        .awlen   (h2f_awlen_o),
        .awsize  (h2f_awsize_o),
        .awburst (h2f_awburst_o),
        .awvalid (h2f_awvalid_o),
        .awready (h2f_awready_i),
        .wdata   (h2f_wdata_o),
        .wstrb   (h2f_wstrb_o),
        .wvalid  (h2f_wvalid_o),
        .wready  (h2f_wready_i),
        .bid     (h2f_bid_i),
        .bresp   (h2f_bresp_i),
        .bvalid  (h2f_bvalid_i),
        .bready  (h2f_bready_o),
        .arid    (h2f_arid_o),
        .araddr  (h2f_araddr_o),
        .arlen   (h2f_arlen_o),
        .arsize  (h2f_arsize_o),
        .arburst (h2f_arburst_o),
        .arvalid (h2f_arvalid_o),
        .arready (h2f_arready_i),
        .rid     (h2f_rid_i),
        .rdata   (h2f_rdata_i),
        .rresp   (h2f_rresp_i),
        .rlast   (h2f_rlast_i),
        .rvalid  (h2f_rvalid_i),
        .rready  (h2f_rready_o),
        .awlock  (),
        .awcache (),
        .awprot  (),
        .wid     (),
        .wlast   (),
        .arlock  (),
        .arcache (),
        .arprot  ()
    );
    // verilator lint_on PINCONNECTEMPTY

    // ---- What is not used -------------------------------------------------
    cyclonev_hps_interface_fpga2hps fpga2hps (.port_size_config(2'b11));  // off

    cyclonev_hps_interface_fpga2sdram fpga2sdram (
        .cfg_axi_mm_select   (6'b0),
        .cfg_cport_type      (12'b0),
        .cfg_port_width      (12'b0),
        .cfg_cport_rfifo_map (18'b0),
        .cfg_cport_wfifo_map (18'b0),
        .cfg_rfifo_cport_map (16'b0),
        .cfg_wfifo_cport_map (16'b0)
    );

    cyclonev_hps_interface_dbg_apb debug (.DBG_APB_DISABLE(1'b0), .P_CLK_EN(1'b0));
    cyclonev_hps_interface_tpiu_trace trace (.traceclk_ctl(1'b1));

    cyclonev_hps_interface_boot_from_fpga boot_from_fpga (
        .boot_from_fpga_ready      (1'b0),
        .boot_from_fpga_on_failure (1'b0),
        .bsel_en                   (1'b0),
        .csel_en                   (1'b0),
        .bsel                      (3'b001),
        .csel                      (2'b01)
    );
endmodule

`default_nettype wire
