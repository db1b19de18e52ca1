// cyclonev_clkselect.v - device primitive: one of four clocks

`default_nettype none

module cyclonev_clkselect #(
    // Without meaning here.
    parameter test_cff = "low", TEST_CFF = test_cff,
    parameter lpm_type = "cyclonev_clkselect", LPM_TYPE = lpm_type
) (
    input  wire [3:0] inclk,
    input  wire [1:0] clkselect,
    output wire       outclk
);
    assign outclk = inclk[clkselect];
endmodule

`default_nettype wire
