// altera_std_synchronizer_bundle.v - an altera_std_synchronizer for each bit of a signal

`default_nettype none

module altera_std_synchronizer_bundle #(
    parameter depth = 3, DEPTH = depth,
    parameter width = 1, WIDTH = width
) (
    input  wire             clk,
    input  wire             reset_n,
    input  wire [WIDTH-1:0] din,
    output wire [WIDTH-1:0] dout
);
    genvar i;
    generate
        for (i = 0; i < WIDTH; i = i + 1) begin : bits
            altera_std_synchronizer #(.depth(DEPTH)) bit_chain (
                .clk(clk), .reset_n(reset_n), .din(din[i]), .dout(dout[i]));
        end
    endgenerate
endmodule

`default_nettype wire
