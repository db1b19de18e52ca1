// cyclonev_hps_interface_dma.v - requests to the processor's DMA controller, its peripherals 0 to 7
//
// A peripheral asks for a burst by req, for a single transfer by single.  When that has been done
// ack is 1 until the request has been taken back.

`default_nettype none

module cyclonev_hps_interface_dma (
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
);
    de1sim_hps_wires #(
        .KIND(5), .NUMBER(0), .FROM(16), .TO(8)
    ) wires (
        .from_i({channel7_single, channel6_single, channel5_single, channel4_single,
                 channel3_single, channel2_single, channel1_single, channel0_single,
                 channel7_req, channel6_req, channel5_req, channel4_req,
                 channel3_req, channel2_req, channel1_req, channel0_req}),
        .to_o({channel7_xx_ack, channel6_xx_ack, channel5_xx_ack, channel4_xx_ack,
               channel3_xx_ack, channel2_xx_ack, channel1_xx_ack, channel0_xx_ack})
    );
endmodule

`default_nettype wire
