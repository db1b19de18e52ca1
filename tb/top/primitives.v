// primitives.v - the vendor's primitives in de1_soc_top.v, handed on to top_fabric.v's ports
//
// What the processor's bridges, the host's terminals and the PLLs put into the chip comes from
// there.  With PORTS_ALONE, for linters, nothing is behind the ports: their names, widths and
// directions are what they check.

`default_nettype none

// verilator lint_off DECLFILENAME
// verilator lint_off UNUSED
// verilator lint_off UNDRIVEN

// ---- PLLs ----

// The fabric's PLL is locked after six clocks, so that the fabric's reset ends after eight, when
// sim/fpga/fabric.cpp lets fpga.v begin.  The audio PLL's clock is divided by twelve in the chip,
// so it is six pulses for each edge of the audio clock.
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
`ifndef PORTS_ALONE
    assign fboutclk = 1'b0;

    generate
        if (output_clock_frequency0 == "12.288000 MHz") begin : audio
            six_pulses pulses (.clk_i(top_fabric.clk_audio_i), .clk_o(outclk));
            assign locked = 1'b1;
        end else if (output_clock_frequency0 == "25.000000 MHz") begin : fabric
            reg [2:0] clocks_q = 3'd0;

            assign outclk = top_fabric.clk_i;
            assign locked = clocks_q == 3'd6;
            always @(posedge outclk) if (!locked) clocks_q <= clocks_q + 3'd1;
        end
    endgenerate
`endif
endmodule

`ifndef PORTS_ALONE
// In one evaluation: clk_o rises until the sixth rise has taken over clk_i, and falls after each.
module six_pulses (
    input  wire clk_i,
    output wire clk_o
);
    reg       seen_q = 1'b0, rises_q = 1'b0, falls_q = 1'b0;
    reg [2:0] count_q = 3'd0;

    assign clk_o = clk_i != seen_q && rises_q == falls_q;

    always @(posedge clk_o) begin
        rises_q <= !rises_q;
        count_q <= count_q == 3'd5 ? 3'd0 : count_q + 3'd1;
        if (count_q == 3'd5) seen_q <= clk_i;
    end
    always @(negedge clk_o) falls_q <= rises_q;
endmodule
`endif

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
`ifndef PORTS_ALONE
    assign r_ena   = top_fabric.jtag_take_i[INSTANCE_ID];
    assign t_dat   = top_fabric.jtag_typed_data_i[8 * INSTANCE_ID +: 8];
    assign t_ena   = top_fabric.jtag_typed_i[INSTANCE_ID];
    assign t_pause = top_fabric.jtag_idle_i[INSTANCE_ID];
`endif
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
`ifndef PORTS_ALONE
    assign awid    = top_fabric.lw_awid_i;
    assign awaddr  = top_fabric.lw_awaddr_i;
    assign awlen   = top_fabric.lw_awlen_i;
    assign awsize  = top_fabric.lw_awsize_i;
    assign awburst = top_fabric.lw_awburst_i;
    assign awvalid = top_fabric.lw_awvalid_i;
    assign wdata   = top_fabric.lw_wdata_i;
    assign wstrb   = top_fabric.lw_wstrb_i;
    assign wvalid  = top_fabric.lw_wvalid_i;
    assign bready  = top_fabric.lw_bready_i;
    assign arid    = top_fabric.lw_arid_i;
    assign araddr  = top_fabric.lw_araddr_i;
    assign arlen   = top_fabric.lw_arlen_i;
    assign arsize  = top_fabric.lw_arsize_i;
    assign arburst = top_fabric.lw_arburst_i;
    assign arvalid = top_fabric.lw_arvalid_i;
    assign rready  = top_fabric.lw_rready_i;
    assign {wid, wlast, awcache, arcache, awprot, arprot, awlock, arlock} = 0;
`endif
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
`ifndef PORTS_ALONE
    assign awid    = top_fabric.h2f_awid_i;
    assign awaddr  = top_fabric.h2f_awaddr_i;
    assign awlen   = top_fabric.h2f_awlen_i;
    assign awsize  = top_fabric.h2f_awsize_i;
    assign awburst = top_fabric.h2f_awburst_i;
    assign awvalid = top_fabric.h2f_awvalid_i;
    assign wdata   = top_fabric.h2f_wdata_i;
    assign wstrb   = top_fabric.h2f_wstrb_i;
    assign wvalid  = top_fabric.h2f_wvalid_i;
    assign bready  = top_fabric.h2f_bready_i;
    assign arid    = top_fabric.h2f_arid_i;
    assign araddr  = top_fabric.h2f_araddr_i;
    assign arlen   = top_fabric.h2f_arlen_i;
    assign arsize  = top_fabric.h2f_arsize_i;
    assign arburst = top_fabric.h2f_arburst_i;
    assign arvalid = top_fabric.h2f_arvalid_i;
    assign rready  = top_fabric.h2f_rready_i;
    assign {wid, wlast, awcache, arcache, awprot, arprot, awlock, arlock} = 0;
`endif
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
