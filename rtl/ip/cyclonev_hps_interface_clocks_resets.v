// cyclonev_hps_interface_clocks_resets.v - resets between processor and FPGA: that of a warm reset

`default_nettype none

module cyclonev_hps_interface_clocks_resets (
    // verilator lint_off UNUSED
    input  wire  f2h_cold_rst_req_n,
    input  wire  f2h_warm_rst_req_n,
    input  wire  f2h_dbg_rst_req_n,
    input  wire  f2h_pending_rst_ack,
    input  wire  ptp_ref_clk,
    output wire  h2f_rst_n,
    output wire  h2f_cold_rst_n,
    output wire  h2f_pending_rst_req_n,
    output wire  h2f_user0_clk,
    output wire  h2f_user1_clk,
    output wire  h2f_user2_clk
    // verilator lint_on UNUSED
);
`ifdef DE1SIM_LISTS
    assign h2f_rst_n = 1'b1;  // the design alone, without the chip
`else
    assign h2f_rst_n = !de1sim_chip.hps_reset;
`endif
    assign {h2f_cold_rst_n, h2f_pending_rst_req_n} = 2'b11;
    assign {h2f_user0_clk, h2f_user1_clk, h2f_user2_clk} = 3'd0;
endmodule

`default_nettype wire
