// de1sim_hps_port.v - where a bridge of the processor meets the chip around the design
//
// In de1sim_chip.v a burst is there when its bit of hps_request differs from that of hps_answer.

`default_nettype none

module de1sim_hps_port #(
    parameter FULL = 0  // 1: HPS-to-FPGA, 0: the lightweight one
) (
    input  wire        clk_i,
    input  wire [1:0]  size_i,    // of the bus behind it: 0: 32 bits, 1: 64, 2: 128, 3: unused

    output wire        begins_o,  // a burst is taken at this clock
    input  wire        ends_i,    // it is answered
    output wire        reset_o,   // ends a burst, which nobody will answer
    input  wire [19:0] waits_i    // for what, as de1sim_chip's hps_waits_o
);
`ifdef DE1SIM_LISTS
    // The design alone, without the chip.
    assign {begins_o, reset_o} = 2'b00;
`else
    localparam [3:0] CLK = 4'd7;

    reg          busy_q = 0, answer_q = 0;
    wire         request = FULL != 0 ? de1sim_chip.hps_request[1] : de1sim_chip.hps_request[0];
    wire [19:0]  waits = busy_q ? waits_i : {16'd0, CLK};

    assign begins_o = !busy_q && request != answer_q && !reset_o;
    assign reset_o  = de1sim_chip.hps_reset[0];

    always @(posedge clk_i) begin
        if (begins_o) busy_q <= 1'b1;
        if (ends_i) begin
            busy_q   <= 1'b0;
            answer_q <= !answer_q;
        end
        if (reset_o) begin
            busy_q   <= 1'b0;
            answer_q <= request;
        end
    end

    generate
        if (FULL != 0) begin : full
            assign de1sim_chip.hps_answer[1] = answer_q;
            assign de1sim_chip.hps_size[3:2] = size_i + 2'd1;
            assign de1sim_chip.hps_waits[39:20] = waits;
        end else begin : lightweight
            assign de1sim_chip.hps_answer[0] = answer_q;
            assign de1sim_chip.hps_size[1:0] = size_i + 2'd1;
            assign de1sim_chip.hps_waits[19:0] = waits;
        end
    endgenerate
`endif
endmodule

`default_nettype wire
