// header.v - the 32 of an expansion header's 36 pins that are a parallel port's bits
//
//   bit  31:15   14   13:1   0
//   pin  35:19   17   15:3   1

`default_nettype none

module header (
    inout  wire [35:0] pins_io,
    output wire [31:0] in_o,
    input  wire [31:0] out_i,
    input  wire [31:0] oe_i      // 1 = driven
);
    wire [31:0] pins = {pins_io[35:19], pins_io[17], pins_io[15:3], pins_io[1]};
    wire [31:0] level;

    genvar i;
    generate
        for (i = 0; i < 32; i = i + 1) begin : pin
            assign level[i] = oe_i[i] ? out_i[i] : 1'bz;
        end
    endgenerate

    assign in_o = pins;
    assign {pins_io[35:19], pins_io[17], pins_io[15:3], pins_io[1]} = level;
endmodule

`default_nettype wire
