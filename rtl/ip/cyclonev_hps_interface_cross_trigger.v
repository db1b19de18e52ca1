// cyclonev_hps_interface_cross_trigger.v - triggers between debuggers: none comes

`default_nettype none

module cyclonev_hps_interface_cross_trigger (
    // verilator lint_off UNUSED
    input  wire [7:0] trig_in,
    input  wire [7:0] trig_outack,
    input  wire       clk,
    input  wire       clk_en,
    // verilator lint_on UNUSED
    output wire [7:0] trig_inack,
    output wire [7:0] trig_out,
    output wire [7:0] asicctl,
    output wire       fake_dout
);
    assign {trig_inack, trig_out, asicctl, fake_dout} = 25'd0;
endmodule

`default_nettype wire
