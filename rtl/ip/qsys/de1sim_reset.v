// de1sim_reset.v - a reset inside of a system: begins at once, ends with the sink's clock

`default_nettype none

module de1sim_reset (
    input  wire clk_i,
    input  wire rst_i,
    output wire rst_o
);
    reg [1:0] line_q = 2'b11;  // active when the chip has powered up
    assign rst_o = line_q[1];

    always @(posedge clk_i or posedge rst_i)
        if (rst_i) line_q <= 2'b11;
        else       line_q <= {line_q[0], 1'b0};
endmodule

`default_nettype wire
