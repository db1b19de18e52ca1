// de1sim_up_characters.v - the University Program's character buffer: a memory of characters, and
// the picture of them as a stream
//
//   avalon_char_buffer_slave    a byte for each character, at 128 * line + column (64 * for 40)
//   avalon_char_control_slave   +0: a write of bit 16 clears the buffer, which takes 8,192 clocks;
//                               +4: 31:16 lines, 15:0 characters of a line
//
// A pixel is white with the full alpha where a character has one, else black with alpha 0.
//
// Source: Intel FPGA University Program, Video Cores for DE-Series Boards.
//
// Not handled: the shapes of the core's own characters: those here are de1sim's.

`default_nettype none

module de1sim_up_characters #(
    parameter COLUMNS = 80,
    parameter LINES   = 60,
    parameter BITS    = 40
) (
    input  wire            clk,
    input  wire            reset,

    input  wire [12:0]     buf_address,
    // verilator lint_off UNUSED
    input  wire            buf_byteenable,
    // verilator lint_on UNUSED
    input  wire            buf_chipselect,
    input  wire            buf_read,
    input  wire            buf_write,
    input  wire [7:0]      buf_writedata,
    output wire [7:0]      buf_readdata,
    output wire            buf_waitrequest,

    input  wire            ctrl_address,
    input  wire [3:0]      ctrl_byteenable,
    input  wire            ctrl_chipselect,
    // verilator lint_off UNUSED
    input  wire            ctrl_read,
    input  wire [31:0]     ctrl_writedata,
    // verilator lint_on UNUSED
    input  wire            ctrl_write,
    output wire [31:0]     ctrl_readdata,

    input  wire            stream_ready,
    output wire [BITS-1:0] stream_data,
    output wire            stream_startofpacket,
    output wire            stream_endofpacket,
    output wire            stream_valid
);
    `include "../vga/character_font.vh"

    localparam SHIFT = COLUMNS > 64 ? 7 : 6;

    reg [7:0]  characters [0:8191];
    reg [12:0] clear_q;
    reg        clears_q;
    reg [9:0]  x_q, y_q;

    wire last_x = x_q == 8 * COLUMNS - 1, last_y = y_q == 8 * LINES - 1;
    wire [12:0] at = ({6'd0, y_q[9:3]} << SHIFT) + {6'd0, x_q[9:3]};
    wire [7:0]  code = characters[at];
    wire [63:0] shape = letter(code[6:0]);
    wire        lit = !code[7] && shape[{y_q[2:0], x_q[2:0]}];

    assign buf_waitrequest      = clears_q && (buf_read || buf_write);
    assign buf_readdata         = characters[buf_address];
    assign ctrl_readdata        = ctrl_address ? {LINES[15:0], COLUMNS[15:0]}
                                               : {15'd0, clears_q, 16'd0};
    assign stream_data          = {BITS{lit}};
    assign stream_startofpacket = x_q == 10'd0 && y_q == 10'd0;
    assign stream_endofpacket   = last_x && last_y;
    assign stream_valid         = 1'b1;

    always @(posedge clk) begin
        if (clears_q) begin
            characters[clear_q] <= 8'h20;
            clear_q             <= clear_q + 13'd1;
            clears_q            <= clear_q != 13'd8191;
        end else if (buf_chipselect && buf_write)
            characters[buf_address] <= buf_writedata;
        if (ctrl_chipselect && ctrl_write && !ctrl_address && ctrl_byteenable[2]
                && ctrl_writedata[16]) begin
            clears_q <= 1'b1;
            clear_q  <= 13'd0;
        end
        if (stream_ready) begin
            x_q <= last_x ? 10'd0 : x_q + 10'd1;
            if (last_x) y_q <= last_y ? 10'd0 : y_q + 10'd1;
        end
        if (reset) begin
            clears_q   <= 1'b1;
            clear_q    <= 13'd0;
            {x_q, y_q} <= 20'd0;
        end
    end
endmodule

`default_nettype wire
