// de1sim_avalon_crossing.v - commands from one clock to another, and their answers back
//
// Commands and answers as in de1sim_avalon_decoder.v.  Each way is a queue of 16 places, whose
// counts cross in Gray code through two registers.

`default_nettype none

module de1sim_avalon_crossing #(
    parameter WIDTH = 32,
    parameter BYTES = WIDTH / 8
) (
    input  wire             clk_i,       // of the master
    input  wire             valid_i,
    output wire             ready_o,
    input  wire             write_i,
    input  wire [15:0]      count_i,
    input  wire [31:0]      address_i,
    input  wire [WIDTH-1:0] wdata_i,
    input  wire [BYTES-1:0] be_i,
    output wire             rvalid_o,
    output wire [WIDTH-1:0] rdata_o,

    input  wire             to_clk_i,    // of the slave
    output wire             valid_o,
    input  wire             ready_i,
    output wire             write_o,
    output wire [15:0]      count_o,
    output wire [31:0]      address_o,
    output wire [WIDTH-1:0] wdata_o,
    output wire [BYTES-1:0] be_o,
    input  wire             rvalid_i,
    input  wire [WIDTH-1:0] rdata_i
);
    localparam COMMAND = 49 + WIDTH + BYTES;

    // An answer has a place when its command is sent.
    reg  [4:0] under_way_q = 0;
    wire       sends = valid_i && ready_o;
    wire       room;
    assign ready_o = room && under_way_q != 5'd16;
    always @(posedge clk_i) under_way_q <= under_way_q + {4'd0, sends} - {4'd0, rvalid_o};

    de1sim_avalon_queue #(.WIDTH(COMMAND)) commands (
        .clk_i(clk_i), .valid_i(valid_i && under_way_q != 5'd16), .ready_o(room),
        .data_i({write_i, count_i, address_i, wdata_i, be_i}),
        .to_clk_i(to_clk_i), .valid_o(valid_o), .ready_i(ready_i),
        .data_o({write_o, count_o, address_o, wdata_o, be_o})
    );

    // verilator lint_off PINCONNECTEMPTY
    de1sim_avalon_queue #(.WIDTH(WIDTH)) answers (
        .clk_i(to_clk_i), .valid_i(rvalid_i), .ready_o(), .data_i(rdata_i),
        .to_clk_i(clk_i), .valid_o(rvalid_o), .ready_i(1'b1), .data_o(rdata_o)
    );
    // verilator lint_on PINCONNECTEMPTY
endmodule

`default_nettype wire
