// cyclonev_clkena.v - device primitive: a clock that is let through while ena is 1
//
// ena is taken at the falling edge of inclk, with "double register" at the one after it; enaout is
// what was taken.  A clock that is not let through is 0.

`default_nettype none
// Texts of different lengths.
// verilator lint_off WIDTH

module cyclonev_clkena #(
    parameter ena_register_mode = "falling edge", ENA_REGISTER_MODE = ena_register_mode,
    parameter ena_register_power_up = "high", ENA_REGISTER_POWER_UP = ena_register_power_up,
    // Without meaning here.
    parameter clock_type = "Auto", CLOCK_TYPE = clock_type,
    parameter disable_mode = "low", DISABLE_MODE = disable_mode,
    parameter test_syn = "high", TEST_SYN = test_syn,
    parameter lpm_type = "cyclonev_clkena", LPM_TYPE = lpm_type
) (
    input  wire inclk, ena,
    output wire enaout, outclk
);
    localparam ALWAYS = ENA_REGISTER_MODE == "always enabled";

    reg [1:0] ena_q = {2{ENA_REGISTER_POWER_UP == "high"}};  // the older one higher
    always @(negedge inclk) ena_q <= {ena_q[0], ena};

    assign enaout = ALWAYS ? 1'b1 : ENA_REGISTER_MODE == "double register" ? ena_q[1] : ena_q[0];
    assign outclk = inclk & enaout;
// verilator lint_on WIDTH
endmodule

`default_nettype wire
