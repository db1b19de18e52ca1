// primitives.v - the ports of the vendor's primitives in de1_soc_top.v, for linters
//
// rtl/ip has the primitives themselves, with what only the simulation reads.

`default_nettype none

// verilator lint_off DECLFILENAME
// verilator lint_off UNUSED
// verilator lint_off UNDRIVEN

// ---- PLLs ----

module altera_pll #(
    parameter reference_clock_frequency = "", operation_mode = "", fractional_vco_multiplier = "",
              number_of_clocks = 1, output_clock_frequency0 = "", phase_shift0 = "",
              duty_cycle0 = 50, pll_type = "", pll_subtype = ""
) (
    input  wire refclk,
    input  wire rst,
    input  wire fbclk,
    output wire fboutclk,
    output wire outclk,
    output wire locked
);
endmodule

// ---- The host ----

module alt_jtag_atlantic #(
    parameter INSTANCE_ID = 0, LOG2_RXFIFO_DEPTH = 0, LOG2_TXFIFO_DEPTH = 0,
              SLD_AUTO_INSTANCE_INDEX = ""
) (
    input  wire       clk,
    input  wire       rst_n,
    input  wire [7:0] r_dat,
    input  wire       r_val,
    output wire       r_ena,
    output wire [7:0] t_dat,
    input  wire       t_dav,
    output wire       t_ena,
    output wire       t_pause
);
endmodule

// ---- The processor ----

module cyclonev_hps_interface_clocks_resets (
    output wire h2f_rst_n,
    input  wire f2h_cold_rst_req_n, f2h_warm_rst_req_n, f2h_dbg_rst_req_n, f2h_pending_rst_ack
);
    assign h2f_rst_n = 1'b1;
endmodule

module cyclonev_hps_interface_interrupts (
    input  wire [63:0] irq
);
endmodule

module cyclonev_hps_interface_hps2fpga_light_weight (
    input  wire        clk,
    output wire [11:0] awid, arid, wid,
    output wire [20:0] awaddr, araddr,
    output wire [3:0]  awlen, arlen, wstrb, awcache, arcache,
    output wire [2:0]  awsize, arsize, awprot, arprot,
    output wire [1:0]  awburst, arburst, awlock, arlock,
    output wire        awvalid, arvalid, wvalid, wlast, bready, rready,
    output wire [31:0] wdata,
    input  wire [11:0] bid, rid,
    input  wire [31:0] rdata,
    input  wire [1:0]  bresp, rresp,
    input  wire        awready, wready, bvalid, arready, rlast, rvalid
);
endmodule

module cyclonev_hps_interface_hps2fpga (
    input  wire [1:0]  port_size_config,
    input  wire        clk,
    output wire [11:0] awid, arid, wid,
    output wire [29:0] awaddr, araddr,
    output wire [3:0]  awlen, arlen, wstrb, awcache, arcache,
    output wire [2:0]  awsize, arsize, awprot, arprot,
    output wire [1:0]  awburst, arburst, awlock, arlock,
    output wire        awvalid, arvalid, wvalid, wlast, bready, rready,
    output wire [31:0] wdata,
    input  wire [11:0] bid, rid,
    input  wire [31:0] rdata,
    input  wire [1:0]  bresp, rresp,
    input  wire        awready, wready, bvalid, arready, rlast, rvalid
);
endmodule

// ---- What is switched off ----

module cyclonev_hps_interface_fpga2hps (
    input  wire [1:0]  port_size_config
);
endmodule

module cyclonev_hps_interface_fpga2sdram (
    input  wire [5:0]  cfg_axi_mm_select,
    input  wire [11:0] cfg_cport_type, cfg_port_width,
    input  wire [17:0] cfg_cport_rfifo_map, cfg_cport_wfifo_map,
    input  wire [15:0] cfg_rfifo_cport_map, cfg_wfifo_cport_map
);
endmodule

module cyclonev_hps_interface_dbg_apb (
    input  wire        DBG_APB_DISABLE, P_CLK_EN
);
endmodule

module cyclonev_hps_interface_tpiu_trace (
    input  wire        traceclk_ctl
);
endmodule

module cyclonev_hps_interface_boot_from_fpga (
    input  wire        boot_from_fpga_ready, boot_from_fpga_on_failure, bsel_en, csel_en,
    input  wire [2:0]  bsel,
    input  wire [1:0]  csel
);
endmodule

`default_nettype wire
