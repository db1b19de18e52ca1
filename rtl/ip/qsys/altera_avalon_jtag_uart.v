// altera_avalon_jtag_uart.v - Platform Designer's JTAG UART
//
//   0 data     read: RAVAIL[31:16] left after this one, RVALID bit 15, bits 14:8 as in control, the
//              oldest byte, which goes away; write: a byte to the PC, dropped if WSPACE is 0
//   1 control  RE bit 0, WE bit 1: enable RI and WI, which interrupt; RI bit 8: little room from
//              the PC, or it has paused after bytes and data has not been read since; WI bit 9: few
//              bytes wait for the PC; AC bit 10: the PC has been active, write 1 clears; bit 12:
//              bytes wait; bit 13: there is room to the PC; bit 14: the last byte was dropped;
//              RVALID bit 15 of the last read of data; WSPACE[31:16]: room for bytes to the PC
//
// An access takes two clocks.
//
// Source: Embedded Peripherals IP User Guide, JTAG UART Core, and the Verilog that it generates.

`default_nettype none

module altera_avalon_jtag_uart #(
    parameter READ_DEPTH      = 64,  // powers of two
    parameter WRITE_DEPTH     = 64,
    parameter READ_THRESHOLD  = 8,
    parameter WRITE_THRESHOLD = 8
) (
    input  wire        clk,
    input  wire        rst_n,
    input  wire        av_chipselect,
    input  wire        av_address,
    input  wire        av_read_n,
    input  wire        av_write_n,
    // verilator lint_off UNUSED
    input  wire [31:0] av_writedata,
    // verilator lint_on UNUSED
    output wire [31:0] av_readdata,
    output reg         av_waitrequest,
    output wire        av_irq
);
    // Counts of up to 32,768 bytes, of which registers show 16 bits.
    reg [15:0] read_count_q, write_count_q, read_first_q, write_first_q;
    reg [7:0]  read_bytes [0:READ_DEPTH - 1], write_bytes [0:WRITE_DEPTH - 1];
    reg [7:0]  read_q, sent_q;
    reg        re_q, we_q, ac_q, pause_q, valid_q, lost_q, of_data_q, sent_valid_q;

    wire       takes, typed, paused;
    wire [7:0] typed_data;
    wire       some  = read_count_q != 16'd0;
    wire       room  = read_count_q != READ_DEPTH[15:0];
    wire       full  = write_count_q == WRITE_DEPTH[15:0];
    wire       sends = takes && write_count_q != 16'd0;
    wire       reads_data  = av_chipselect && !av_read_n && av_waitrequest && !av_address;
    wire       reads       = av_chipselect && !av_read_n && av_waitrequest;
    wire       writes      = av_chipselect && !av_write_n && av_waitrequest;
    wire       pushes      = writes && !av_address && !full;
    wire       pops        = reads_data && some;

    wire ri = re_q && (pause_q || READ_DEPTH[15:0] - read_count_q <= READ_THRESHOLD[15:0]);
    wire wi = we_q && write_count_q <= WRITE_THRESHOLD[15:0];
    assign av_irq = ri || wi;
    assign av_readdata =
        of_data_q ? {read_count_q, valid_q, lost_q, !full, some, 1'b0, ac_q, wi, ri, read_q}
        : {WRITE_DEPTH[15:0] - write_count_q, valid_q, lost_q, !full, some, 1'b0, ac_q, wi, ri,
           6'd0, we_q, re_q};

    // Depths are powers of two, of which indices take as many bits as they need.
    // verilator lint_off WIDTH
    function [15:0] place;
        input [15:0] first, count, depth;
        place = (first + count) & (depth - 16'd1);
    endfunction
    // verilator lint_off UNUSED
    wire [15:0] read_end  = place(read_first_q, read_count_q, READ_DEPTH),
                write_end = place(write_first_q, write_count_q, WRITE_DEPTH);
    // verilator lint_on UNUSED

    always @(posedge clk) begin
        if (pops) read_q <= read_bytes[read_first_q];
        if (typed && room) read_bytes[read_end] <= typed_data;
        if (sends) sent_q <= write_bytes[write_first_q];
        if (pushes) write_bytes[write_end] <= av_writedata[7:0];
    end
    // verilator lint_on WIDTH

    always @(posedge clk) begin
        if (!rst_n) begin
            {read_count_q, write_count_q, read_first_q, write_first_q} <= 64'd0;
            {re_q, we_q, ac_q, pause_q, valid_q, lost_q, of_data_q, sent_valid_q} <= 8'd0;
            av_waitrequest <= 1'b1;
        end else begin
            av_waitrequest <= !(av_chipselect && (!av_read_n || !av_write_n) && av_waitrequest);
            sent_valid_q   <= sends;
            read_count_q   <= read_count_q + {15'd0, typed && room} - {15'd0, pops};
            write_count_q  <= write_count_q + {15'd0, pushes} - {15'd0, sends};
            if (pops) read_first_q <= place(read_first_q, 16'd1, READ_DEPTH[15:0]);
            if (sends) write_first_q <= place(write_first_q, 16'd1, WRITE_DEPTH[15:0]);
            if (reads) of_data_q <= !av_address;
            if (reads_data) valid_q <= some;
            if (writes && !av_address) lost_q <= full;
            if (writes && av_address) {we_q, re_q} <= av_writedata[1:0];
            if (typed || paused) ac_q <= 1'b1;
            else if (writes && av_address && av_writedata[10]) ac_q <= 1'b0;
            if (paused && some) pause_q <= 1'b1;
            else if (reads_data) pause_q <= 1'b0;
        end
    end

    alt_jtag_atlantic pc (
        .clk(clk), .rst_n(rst_n), .r_dat(sent_q), .r_val(sent_valid_q), .r_ena(takes),
        .t_dav(room), .t_ena(typed), .t_dat(typed_data), .t_pause(paused)
    );
endmodule

`default_nettype wire
