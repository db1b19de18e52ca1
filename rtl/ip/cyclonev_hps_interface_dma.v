// cyclonev_hps_interface_dma.v - requests to the processor's DMA controller: none is answered

`default_nettype none

module cyclonev_hps_interface_dma (
    // verilator lint_off UNUSED
    input  wire  channel0_req,
    input  wire  channel0_single,
    input  wire  channel1_req,
    input  wire  channel1_single,
    input  wire  channel2_req,
    input  wire  channel2_single,
    input  wire  channel3_req,
    input  wire  channel3_single,
    input  wire  channel4_req,
    input  wire  channel4_single,
    input  wire  channel5_req,
    input  wire  channel5_single,
    input  wire  channel6_req,
    input  wire  channel6_single,
    input  wire  channel7_req,
    input  wire  channel7_single,
    output wire  channel0_xx_ack,
    output wire  channel1_xx_ack,
    output wire  channel2_xx_ack,
    output wire  channel3_xx_ack,
    output wire  channel4_xx_ack,
    output wire  channel5_xx_ack,
    output wire  channel6_xx_ack,
    output wire  channel7_xx_ack
    // verilator lint_on UNUSED
);
    assign {channel0_xx_ack, channel1_xx_ack, channel2_xx_ack, channel3_xx_ack, channel4_xx_ack,
            channel5_xx_ack, channel6_xx_ack, channel7_xx_ack} = 8'd0;
endmodule

`default_nettype wire
