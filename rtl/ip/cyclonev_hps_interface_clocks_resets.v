// cyclonev_hps_interface_clocks_resets.v - clocks and resets between processor and FPGA
//
// The user clocks are as the DE1-SoC's preloader sets them, or as the Platform Designer system has
// them.  A request resets the processor and, by h2f_rst_n, the FPGA; the processor stays in reset
// while the request is low.
//
// Not handled: the handshake before a warm reset (h2f_pending_rst_req_n); a debug reset, which
// the program cannot see but in the reset manager's stat.

`default_nettype none

module cyclonev_hps_interface_clocks_resets #(
    // The device's primitive has no parameters.
    parameter user0_period_fs = 10000000, USER0_PERIOD_FS = user0_period_fs,
    parameter user1_period_fs = 512000000, USER1_PERIOD_FS = user1_period_fs,
    parameter user2_period_fs = 7500000, USER2_PERIOD_FS = user2_period_fs
) (
    input  wire  f2h_cold_rst_req_n,
    input  wire  f2h_warm_rst_req_n,
    input  wire  f2h_dbg_rst_req_n,
    // verilator lint_off UNUSED
    input  wire  f2h_pending_rst_ack,
    input  wire  ptp_ref_clk,
    // verilator lint_on UNUSED
    output wire  h2f_rst_n,
    output wire  h2f_cold_rst_n,
    output wire  h2f_pending_rst_req_n,
    output wire  h2f_user0_clk,
    output wire  h2f_user1_clk,
    output wire  h2f_user2_clk
);
`ifdef DE1SIM_LISTS
    // The design alone, without the chip.
    assign {h2f_rst_n, h2f_cold_rst_n} = 2'b11;
    // verilator lint_off UNUSED
    wire unused = &{1'b0, f2h_cold_rst_req_n, f2h_warm_rst_req_n, f2h_dbg_rst_req_n};
    // verilator lint_on UNUSED
`else
    assign {h2f_cold_rst_n, h2f_rst_n} = ~de1sim_chip.hps_reset;
    assign de1sim_chip.hps_reset_requests =
        ~{f2h_dbg_rst_req_n, f2h_warm_rst_req_n, f2h_cold_rst_req_n};
`endif
    assign h2f_pending_rst_req_n = 1'b1;

    // Each of them is a clock of the simulation only where it is connected.
    de1sim_pll_tap #(
        .PERIOD_FS(USER0_PERIOD_FS), .PHASE_FS(64'd0), .HIGH_FS(64'd0 + USER0_PERIOD_FS / 2)
    ) user0 (
        .clk(h2f_user0_clk), .set_i(1'b0), .period_fs_i(64'd0), .high_fs_i(64'd0)
    );
    de1sim_pll_tap #(
        .PERIOD_FS(USER1_PERIOD_FS), .PHASE_FS(64'd0), .HIGH_FS(64'd0 + USER1_PERIOD_FS / 2)
    ) user1 (
        .clk(h2f_user1_clk), .set_i(1'b0), .period_fs_i(64'd0), .high_fs_i(64'd0)
    );
    de1sim_pll_tap #(
        .PERIOD_FS(USER2_PERIOD_FS), .PHASE_FS(64'd0), .HIGH_FS(64'd0 + USER2_PERIOD_FS / 2)
    ) user2 (
        .clk(h2f_user2_clk), .set_i(1'b0), .period_fs_i(64'd0), .high_fs_i(64'd0)
    );
endmodule

`default_nettype wire
