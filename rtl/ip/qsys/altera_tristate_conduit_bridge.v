// altera_tristate_conduit_bridge.v - Platform Designer's pins of a bus outside
//
// Every signal goes through a register, each way, and the bus is granted a clock after it is asked
// for.  Outputs are those that the system's pins name, in the order of its parameter.
//
// Source: Platform Designer User Guide, Tri-State Conduit Bridge.
//
// Not handled: outputs are driven also in reset, where the device's are released.

`default_nettype none

module altera_tristate_conduit_bridge #(
    parameter W0 = 1, parameter W1 = 1, parameter W2 = 1, parameter W3 = 1,
    parameter W4 = 1, parameter W5 = 1, parameter W6 = 1, parameter W7 = 1,
    parameter W8 = 1, parameter W9 = 1, parameter W10 = 1, parameter W11 = 1,
    parameter W12 = 1, parameter W13 = 1, parameter W14 = 1, parameter W15 = 1,
    parameter DATA = 16
) (
    input  wire             clk,
    input  wire             reset,
    input  wire             request,
    output reg              grant,

    input  wire [DATA-1:0]  data_out,
    input  wire             data_outen,
    output reg  [DATA-1:0]  data_in,
    inout  wire [DATA-1:0]  data_io,
    input  wire             wait_i,
    output reg              wait_o,

    input  wire [W0-1:0]  p0_i,
    output wire [W0-1:0]  p0_o,
    input  wire [W1-1:0]  p1_i,
    output wire [W1-1:0]  p1_o,
    input  wire [W2-1:0]  p2_i,
    output wire [W2-1:0]  p2_o,
    input  wire [W3-1:0]  p3_i,
    output wire [W3-1:0]  p3_o,
    input  wire [W4-1:0]  p4_i,
    output wire [W4-1:0]  p4_o,
    input  wire [W5-1:0]  p5_i,
    output wire [W5-1:0]  p5_o,
    input  wire [W6-1:0]  p6_i,
    output wire [W6-1:0]  p6_o,
    input  wire [W7-1:0]  p7_i,
    output wire [W7-1:0]  p7_o,
    input  wire [W8-1:0]  p8_i,
    output wire [W8-1:0]  p8_o,
    input  wire [W9-1:0]  p9_i,
    output wire [W9-1:0]  p9_o,
    input  wire [W10-1:0]  p10_i,
    output wire [W10-1:0]  p10_o,
    input  wire [W11-1:0]  p11_i,
    output wire [W11-1:0]  p11_o,
    input  wire [W12-1:0]  p12_i,
    output wire [W12-1:0]  p12_o,
    input  wire [W13-1:0]  p13_i,
    output wire [W13-1:0]  p13_o,
    input  wire [W14-1:0]  p14_i,
    output wire [W14-1:0]  p14_o,
    input  wire [W15-1:0]  p15_i,
    output wire [W15-1:0]  p15_o
);
    reg [DATA-1:0] data_q;
    reg            outen_q = 1'b0;
    assign data_io = outen_q ? data_q : {DATA{1'bz}};

    always @(posedge clk) begin
        grant   <= request && !reset;
        data_q  <= data_out;
        outen_q <= data_outen && !reset;
        data_in <= data_io;
        wait_o  <= wait_i;
    end

    // The outputs, which before the first clock are those of the controller.
    reg begun_q = 1'b0;
    always @(posedge clk) begun_q <= 1'b1;
    reg [W0-1:0] p0_q; assign p0_o = begun_q ? p0_q : p0_i;
    reg [W1-1:0] p1_q; assign p1_o = begun_q ? p1_q : p1_i;
    reg [W2-1:0] p2_q; assign p2_o = begun_q ? p2_q : p2_i;
    reg [W3-1:0] p3_q; assign p3_o = begun_q ? p3_q : p3_i;
    reg [W4-1:0] p4_q; assign p4_o = begun_q ? p4_q : p4_i;
    reg [W5-1:0] p5_q; assign p5_o = begun_q ? p5_q : p5_i;
    reg [W6-1:0] p6_q; assign p6_o = begun_q ? p6_q : p6_i;
    reg [W7-1:0] p7_q; assign p7_o = begun_q ? p7_q : p7_i;
    reg [W8-1:0] p8_q; assign p8_o = begun_q ? p8_q : p8_i;
    reg [W9-1:0] p9_q; assign p9_o = begun_q ? p9_q : p9_i;
    reg [W10-1:0] p10_q; assign p10_o = begun_q ? p10_q : p10_i;
    reg [W11-1:0] p11_q; assign p11_o = begun_q ? p11_q : p11_i;
    reg [W12-1:0] p12_q; assign p12_o = begun_q ? p12_q : p12_i;
    reg [W13-1:0] p13_q; assign p13_o = begun_q ? p13_q : p13_i;
    reg [W14-1:0] p14_q; assign p14_o = begun_q ? p14_q : p14_i;
    reg [W15-1:0] p15_q; assign p15_o = begun_q ? p15_q : p15_i;
    always @(posedge clk) begin
        {p0_q, p1_q, p2_q, p3_q} <= {p0_i, p1_i, p2_i, p3_i};
        {p4_q, p5_q, p6_q, p7_q} <= {p4_i, p5_i, p6_i, p7_i};
        {p8_q, p9_q, p10_q, p11_q} <= {p8_i, p9_i, p10_i, p11_i};
        {p12_q, p13_q, p14_q, p15_q} <= {p12_i, p13_i, p14_i, p15_i};
    end
endmodule

`default_nettype wire
