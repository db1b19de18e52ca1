// de1sim_pipeline.v - a value, STAGES clocks later; with none at once

`default_nettype none

module de1sim_pipeline #(
    parameter WIDTH  = 1,
    parameter STAGES = 0
) (
    input  wire             clock_i, clken_i,
    input  wire             aclr_i, sclr_i,
    input  wire [WIDTH-1:0] d_i,
    output wire [WIDTH-1:0] q_o
);
    generate
        if (STAGES == 0) begin : wires
            assign q_o = d_i;
        end else begin : registers
            reg [WIDTH*(STAGES+1)-1:0] stages_q;  // the newest lowest, the last one unused
            always @(posedge clock_i or posedge aclr_i)
                if (aclr_i) stages_q <= 0;
                else if (clken_i) stages_q <= sclr_i ? 0 : {stages_q[WIDTH*STAGES-1:0], d_i};
            assign q_o = stages_q[WIDTH*STAGES-1 -: WIDTH];
        end
    endgenerate
endmodule

`default_nettype wire
