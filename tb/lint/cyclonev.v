// cyclonev.v - ports of the Cyclone V primitives that rtl/board uses, without function
//
// For linters: they find a wrong port name, width or direction without the vendor's libraries.

`default_nettype none
/* verilator lint_off DECLFILENAME */
/* verilator lint_off UNUSED */
/* verilator lint_off UNDRIVEN */

module altera_pll #(
    parameter reference_clock_frequency = "0 ps",
    parameter operation_mode = "internal feedback",
    parameter fractional_vco_multiplier = "false",
    parameter number_of_clocks = 1,
    parameter output_clock_frequency0 = "0 ps",
    parameter phase_shift0 = "0 ps",
    parameter duty_cycle0 = 50,
    parameter pll_type = "General",
    parameter pll_subtype = "General"
) (
    input  wire refclk,
    input  wire rst,
    input  wire fbclk,
    output wire fboutclk,
    output wire outclk,
    output wire locked
);
endmodule

module alt_jtag_atlantic #(
    parameter INSTANCE_ID = 0,
    parameter LOG2_RXFIFO_DEPTH = 0,
    parameter LOG2_TXFIFO_DEPTH = 0,
    parameter SLD_AUTO_INSTANCE_INDEX = "NO"
) (
    input  wire clk,
    input  wire rst_n,
    input  wire [7:0] r_dat,
    input  wire r_val,
    output wire r_ena,
    output wire [7:0] t_dat,
    input  wire t_dav,
    output wire t_ena,
    output wire t_pause
);
endmodule

module cyclonev_hps_interface_clocks_resets (
    output wire h2f_rst_n,
    input  wire f2h_cold_rst_req_n,
    input  wire f2h_warm_rst_req_n,
    input  wire f2h_dbg_rst_req_n,
    input  wire f2h_pending_rst_ack
);
endmodule

module cyclonev_hps_interface_interrupts (
    input  wire [63:0] irq
);
endmodule

module cyclonev_hps_interface_hps2fpga_light_weight (
    input  wire clk,
    output wire [11:0] awid,
    output wire [20:0] awaddr,
    output wire [3:0] awlen,
    output wire [2:0] awsize,
    output wire [1:0] awburst,
    output wire [1:0] awlock,
    output wire [3:0] awcache,
    output wire [2:0] awprot,
    output wire awvalid,
    input  wire awready,
    output wire [11:0] wid,
    output wire [31:0] wdata,
    output wire [3:0] wstrb,
    output wire wlast,
    output wire wvalid,
    input  wire wready,
    input  wire [11:0] bid,
    input  wire [1:0] bresp,
    input  wire bvalid,
    output wire bready,
    output wire [11:0] arid,
    output wire [20:0] araddr,
    output wire [3:0] arlen,
    output wire [2:0] arsize,
    output wire [1:0] arburst,
    output wire [1:0] arlock,
    output wire [3:0] arcache,
    output wire [2:0] arprot,
    output wire arvalid,
    input  wire arready,
    input  wire [11:0] rid,
    input  wire [31:0] rdata,
    input  wire [1:0] rresp,
    input  wire rlast,
    input  wire rvalid,
    output wire rready
);
endmodule

module cyclonev_hps_interface_hps2fpga (
    input  wire [1:0] port_size_config,
    input  wire clk,
    output wire [11:0] awid,
    output wire [29:0] awaddr,
    output wire [3:0] awlen,
    output wire [2:0] awsize,
    output wire [1:0] awburst,
    output wire [1:0] awlock,
    output wire [3:0] awcache,
    output wire [2:0] awprot,
    output wire awvalid,
    input  wire awready,
    output wire [11:0] wid,
    output wire [31:0] wdata,
    output wire [3:0] wstrb,
    output wire wlast,
    output wire wvalid,
    input  wire wready,
    input  wire [11:0] bid,
    input  wire [1:0] bresp,
    input  wire bvalid,
    output wire bready,
    output wire [11:0] arid,
    output wire [29:0] araddr,
    output wire [3:0] arlen,
    output wire [2:0] arsize,
    output wire [1:0] arburst,
    output wire [1:0] arlock,
    output wire [3:0] arcache,
    output wire [2:0] arprot,
    output wire arvalid,
    input  wire arready,
    input  wire [11:0] rid,
    input  wire [31:0] rdata,
    input  wire [1:0] rresp,
    input  wire rlast,
    input  wire rvalid,
    output wire rready
);
endmodule

module cyclonev_hps_interface_fpga2hps (
    input  wire [1:0] port_size_config
);
endmodule

module cyclonev_hps_interface_fpga2sdram (
    input  wire [5:0] cfg_axi_mm_select,
    input  wire [11:0] cfg_cport_type,
    input  wire [11:0] cfg_port_width,
    input  wire [17:0] cfg_cport_rfifo_map,
    input  wire [17:0] cfg_cport_wfifo_map,
    input  wire [15:0] cfg_rfifo_cport_map,
    input  wire [15:0] cfg_wfifo_cport_map
);
endmodule

module cyclonev_hps_interface_dbg_apb (
    input  wire DBG_APB_DISABLE,
    input  wire P_CLK_EN
);
endmodule

module cyclonev_hps_interface_tpiu_trace (
    input  wire traceclk_ctl
);
endmodule

module cyclonev_hps_interface_boot_from_fpga (
    input  wire boot_from_fpga_ready,
    input  wire boot_from_fpga_on_failure,
    input  wire bsel_en,
    input  wire csel_en,
    input  wire [2:0] bsel,
    input  wire [1:0] csel
);
endmodule

`default_nettype wire
