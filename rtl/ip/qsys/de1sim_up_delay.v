// de1sim_up_delay.v - what came STEPS steps ago

`default_nettype none

module de1sim_up_delay #(parameter BITS = 8, STEPS = 720) (
    input  wire            clk,
    input  wire            step_i,
    input  wire [BITS-1:0] in_i,
    output wire [BITS-1:0] out_o
);
    reg [BITS-1:0] words [0:STEPS-1];
    reg [15:0]     place_q = 16'd0;

    // verilator lint_off WIDTH
    assign out_o = words[place_q];
    always @(posedge clk) if (step_i) begin
        words[place_q] <= in_i;
        place_q        <= place_q == STEPS - 1 ? 16'd0 : place_q + 16'd1;
    end
    // verilator lint_on WIDTH
endmodule

`default_nettype wire
