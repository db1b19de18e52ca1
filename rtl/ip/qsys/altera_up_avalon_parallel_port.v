// altera_up_avalon_parallel_port.v - the University Program's parallel port: up to 32 bits
//
//   +0 data          read: the inputs, of an output port what was written
//   +4 direction     1 = output; bidirectional ports alone
//   +8 interruptmask
//   +C edgecapture   any write clears all
//
// Inputs are sampled once for data and twice more for edges.
//
// Source: Intel FPGA University Program, Parallel Port for DE-Series Boards.

`default_nettype none
// Strings of different lengths are compared; a port narrower than 32 bits is extended.
// verilator lint_off WIDTH

module altera_up_avalon_parallel_port #(
    parameter WIDTH     = 32,
    parameter DIRECTION = "Input only",  // Output only, Bidirectional
    parameter EDGE      = "Rising",      // Falling, Either
    parameter CAPTURES  = 0,
    parameter IRQ       = "None"         // Edge, Level
) (
    input  wire             clk,
    input  wire             reset,
    input  wire [1:0]       address,
    input  wire [3:0]       byteenable,
    input  wire             chipselect,
    // verilator lint_off UNUSED
    input  wire             read,
    // verilator lint_on UNUSED
    input  wire             write,
    // verilator lint_off UNUSED
    input  wire [31:0]      writedata,   // a narrow port does not use all of it
    // verilator lint_on UNUSED
    output reg  [31:0]      readdata,
    output wire             irq,

    input  wire [WIDTH-1:0] in_port,
    output wire [WIDTH-1:0] out_port,
    inout  wire [WIDTH-1:0] bidir_port
);
    localparam BIDIRECTIONAL = DIRECTION == "Bidirectional";

    reg  [WIDTH-1:0] out_q, direction_q, mask_q, edges_q, first_q, second_q;
    wire [31:0]      lanes  = {{8{byteenable[3]}}, {8{byteenable[2]}}, {8{byteenable[1]}},
                               {8{byteenable[0]}}};
    wire             writes = chipselect && write;
    wire [WIDTH-1:0] pins   = BIDIRECTIONAL ? bidir_port : in_port;
    wire [WIDTH-1:0] edges  = EDGE == "Falling" ? ~first_q & second_q
                            : EDGE == "Rising"  ? first_q & ~second_q
                                                : first_q ^ second_q;

    assign out_port = out_q;
    assign irq = IRQ != "None" && ((IRQ == "Edge" ? edges_q : first_q) & mask_q) != 0;

    genvar n;
    generate
        if (BIDIRECTIONAL) begin : both
            for (n = 0; n < WIDTH; n = n + 1) begin : pin
                assign bidir_port[n] = direction_q[n] ? out_q[n] : 1'bz;
            end
        end
    endgenerate

    function [WIDTH-1:0] merged(input [WIDTH-1:0] was, input [WIDTH-1:0] is,
                                input [WIDTH-1:0] where);
        merged = (was & ~where) | (is & where);
    endfunction

    always @(posedge clk) begin
        first_q  <= pins;
        second_q <= first_q;
        edges_q  <= CAPTURES != 0 ? edges_q | edges : 0;
        if (writes) case (address)
            2'd0: out_q       <= merged(out_q, writedata, lanes);
            2'd1: direction_q <= merged(direction_q, writedata, lanes);
            2'd2: mask_q      <= merged(mask_q, writedata, lanes);
            2'd3: edges_q     <= 0;
        endcase
        case (address)
            2'd0: readdata <= DIRECTION == "Output only" ? out_q : first_q;
            2'd1: readdata <= BIDIRECTIONAL ? direction_q : 0;
            2'd2: readdata <= mask_q;
            2'd3: readdata <= edges_q;
        endcase
        if (reset) {out_q, direction_q, mask_q, edges_q, first_q, second_q, readdata} <= 0;
    end
// verilator lint_on WIDTH
endmodule

`default_nettype wire
