// cyclonev_hps_interface_dbg_apb.v - the debug bus: nobody uses it

`default_nettype none

module cyclonev_hps_interface_dbg_apb (
    // verilator lint_off UNUSED
    input  wire        DBG_APB_DISABLE,
    input  wire        P_CLK_EN,
    input  wire        P_CLK,
    input  wire        P_READY,
    input  wire        P_SLV_ERR,
    input  wire [31:0] P_RDATA,
    // verilator lint_on UNUSED
    output wire [17:0] P_ADDR,
    output wire        P_ADDR_31,
    output wire        P_ENABLE,
    output wire        P_SEL,
    output wire [31:0] P_WDATA,
    output wire        P_WRITE,
    output wire        P_RESET_N
);
    assign {P_ADDR, P_ADDR_31, P_ENABLE, P_SEL, P_WDATA, P_WRITE} = 54'd0;
    assign P_RESET_N = 1'b1;
endmodule

`default_nettype wire
