// altera_avalon_dma.v - Platform Designer's simple DMA controller
//
//   read_master -> FIFO -> write_master, in units of 1, 2, 4, 8 or 16 bytes
//
//   0 status        0 DONE 1 BUSY 4 LEN; a write clears the first and the last
//   1 readaddress   2 writeaddress   3 length, in bytes, less what has been written
//   6 control       0 BYTE 1 HW 2 WORD 3 GO 4 I_EN 7 LEEN 8 RCON 9 WCON 10 DOUBLEWORD 11 QUADWORD
//                   12 SOFTWARERESET, which is written twice; WORD and LEEN after a reset
//
// With GO it reads and writes until the length is 0; with RCON or WCON that address stays.  The
// interrupt is DONE with I_EN.
//
// Source: Embedded Peripherals IP User Guide, DMA Controller Core, and its component's description.
//
// Not handled: the end of a packet (REEN, WEEN), whose signals Platform Designer has not.

`default_nettype none

module altera_avalon_dma #(
    parameter WIDTH     = 128,
    parameter FIFO_LOG2 = 5,
    parameter COUNT     = 8,    // bits of the burst count, which is 1
    parameter BYTES     = WIDTH / 8
) (
    input  wire             clk,
    input  wire             system_reset_n,

    input  wire [2:0]       dma_ctl_address,
    input  wire             dma_ctl_chipselect,
    input  wire             dma_ctl_write_n,
    input  wire [31:0]      dma_ctl_writedata,
    output reg  [31:0]      dma_ctl_readdata,
    output wire             dma_ctl_irq,

    output wire [31:0]      read_address,
    output wire             read_chipselect,
    output wire             read_read_n,
    output wire [BYTES-1:0] read_byteenable,
    output wire [COUNT-1:0] read_burstcount,
    input  wire [WIDTH-1:0] read_readdata,
    input  wire             read_readdatavalid,
    input  wire             read_waitrequest,

    output wire [31:0]      write_address,
    output wire             write_chipselect,
    output wire             write_write_n,
    output wire [BYTES-1:0] write_byteenable,
    output wire [COUNT-1:0] write_burstcount,
    output wire [WIDTH-1:0] write_writedata,
    input  wire             write_waitrequest
);
    localparam LOW = BYTES - 1;
    localparam [31:0] MASK = LOW;
    localparam [FIFO_LOG2:0] FULL = 1 << FIFO_LOG2;
    localparam [12:0] AFTER_RESET = 13'h084;

    // ---- Registers --------------------------------------------------------
    reg  [31:0] from_q, to_q, length_q;
    reg  [31:0] to_read_q;      // bytes
    reg  [12:0] control_q;
    reg         done_q, len_q, was_done_q, resets_q;
    wire        writes  = dma_ctl_chipselect && !dma_ctl_write_n;
    wire        go      = control_q[3];
    wire [31:0] size    = control_q[11] ? 32'd16 : control_q[10] ? 32'd8 : control_q[2] ? 32'd4
                          : control_q[1] ? 32'd2 : 32'd1;
    wire        read_taken, write_taken, read_under_way, write_under_way;
    // verilator lint_off UNUSED
    wire        is_done = go && control_q[7] && length_q == 32'd0 && !read_under_way
                          && !write_under_way;
    // verilator lint_on UNUSED
    wire        restarts = writes && dma_ctl_address == 3'd6 && dma_ctl_writedata[12] && resets_q;
    wire        rst = !system_reset_n || restarts;

    assign dma_ctl_irq = control_q[4] && done_q;

    always @(posedge clk) begin
        case (dma_ctl_address)
            3'd0:    dma_ctl_readdata <= {27'd0, len_q, 2'b00,
                                          go && (length_q != 32'd0 || read_under_way
                                                 || write_under_way), done_q};
            3'd1:    dma_ctl_readdata <= from_q;
            3'd2:    dma_ctl_readdata <= to_q;
            3'd3:    dma_ctl_readdata <= length_q;
            3'd6:    dma_ctl_readdata <= {19'd0, control_q};
            default: dma_ctl_readdata <= 32'd0;
        endcase
        if (read_taken) begin
            if (!control_q[8]) from_q <= from_q + size;
            to_read_q <= to_read_q > size ? to_read_q - size : 32'd0;
        end
        if (write_taken) begin
            if (!control_q[9]) to_q <= to_q + size;
            length_q <= length_q > size ? length_q - size : 32'd0;
        end
        was_done_q <= is_done;
        if (is_done && !was_done_q) {done_q, len_q} <= 2'b11;
        if (writes)
            case (dma_ctl_address)
                3'd0:    {done_q, len_q} <= 2'b00;
                3'd1:    from_q <= dma_ctl_writedata;
                3'd2:    to_q   <= dma_ctl_writedata;
                3'd3:    begin length_q <= dma_ctl_writedata; to_read_q <= dma_ctl_writedata; end
                3'd6:    begin
                             control_q <= dma_ctl_writedata[12:0];
                             resets_q  <= dma_ctl_writedata[12];
                         end
                default: ;
            endcase
        if (rst) begin
            {from_q, to_q, length_q, to_read_q} <= 128'd0;
            control_q <= AFTER_RESET;
            {done_q, len_q, was_done_q, resets_q} <= 4'd0;
        end
    end

    // ---- Reads ------------------------------------------------------------
    reg  [31:0]        address_q;
    reg                read_q;
    reg  [BYTES-1:0]   lanes_q;
    reg  [4:0]         places_q [0:(1<<FIFO_LOG2)-1];   // of what is to come, in its word
    reg  [FIFO_LOG2:0] asked_q, came_q, gone_q;
    reg                drops_q;                         // what comes is from before the reset
    wire [31:0]        place = from_q & MASK & ~(size - 32'd1);
    wire [BYTES-1:0]   ones  = {BYTES{1'b1}} >> BYTES - size;

    assign read_address    = address_q;
    assign read_chipselect = read_q;
    assign read_read_n     = !read_q;
    assign read_byteenable = lanes_q;
    assign read_burstcount = 1;
    assign read_taken      = go && !rst && !drops_q && to_read_q != 32'd0
                             && asked_q - gone_q != FULL && (!read_q || !read_waitrequest);
    assign read_under_way  = asked_q != came_q;

    always @(posedge clk) begin
        if (!read_waitrequest) read_q <= 1'b0;
        if (read_taken) begin
            read_q    <= 1'b1;
            address_q <= from_q & ~MASK;
            lanes_q   <= ones << place;
            places_q[asked_q[FIFO_LOG2-1:0]] <= place[4:0];
            asked_q   <= asked_q + 1'b1;
        end
        came_q <= came_q + {{FIFO_LOG2{1'b0}}, read_readdatavalid};
        if (restarts) drops_q <= 1'b1;
        else if (!read_under_way) drops_q <= 1'b0;
        if (!system_reset_n) begin
            {asked_q, came_q} <= 0;
            {read_q, drops_q} <= 2'b00;
        end
    end

    // ---- Writes -----------------------------------------------------------
    reg  [127:0] words_q [0:(1<<FIFO_LOG2)-1];
    reg  [31:0]  write_address_q;
    reg          write_q;
    reg  [BYTES-1:0] write_lanes_q;
    reg  [WIDTH-1:0] data_q;
    wire [31:0]  write_place = to_q & MASK & ~(size - 32'd1);
    // verilator lint_off WIDTH
    wire [127:0] shifted = read_readdata >> places_q[came_q[FIFO_LOG2-1:0]] * 8;
    wire [WIDTH-1:0] next = words_q[gone_q[FIFO_LOG2-1:0]] << write_place * 8;
    // verilator lint_on WIDTH

    assign write_address    = write_address_q;
    assign write_chipselect = write_q;
    assign write_write_n    = !write_q;
    assign write_byteenable = write_lanes_q;
    assign write_burstcount = 1;
    assign write_writedata  = data_q;
    assign write_taken      = go && !rst && !drops_q && came_q != gone_q
                              && (!write_q || !write_waitrequest);
    assign write_under_way  = write_q || came_q != gone_q;

    always @(posedge clk) begin
        if (read_readdatavalid) words_q[came_q[FIFO_LOG2-1:0]] <= shifted;
        if (!write_waitrequest) write_q <= 1'b0;
        if (write_taken) begin
            write_q         <= 1'b1;
            write_address_q <= to_q & ~MASK;
            write_lanes_q   <= ones << write_place;
            data_q          <= next;
            gone_q          <= gone_q + 1'b1;
        end
        if (drops_q) gone_q <= came_q;
        if (!system_reset_n) begin
            gone_q  <= 0;
            write_q <= 1'b0;
        end
    end
endmodule

`default_nettype wire
