// cyclonev_hps_interface_dbg_apb.v - the debug bus: nobody uses it

`default_nettype none

module cyclonev_hps_interface_dbg_apb (
    // verilator lint_off UNUSED
    input  wire  DBG_APB_DISABLE,
    input  wire  P_CLK_EN
    // verilator lint_on UNUSED
);
endmodule

`default_nettype wire
