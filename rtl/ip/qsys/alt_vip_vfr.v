// alt_vip_vfr.v - the Video and Image Processing Suite's Frame Reader: frames as a stream
//
//   memory -> master -> FIFO -> pixels of a word, lowest first -> packets
//
//   0 control: bit 0 go, bit 1 interrupts   1 status: bit 0 it reads a frame
//   2 interrupt: bit 1 a frame has been read, writing 1 clears   3 frame: 0 or 1
//   from 4 on of frame 0, from 11 on of frame 1: address, words, pixels, -, width, height,
//   interlaced
//
// A frame is a control packet (type 15: width, height and interlaced in nibbles, one to a symbol)
// and a video packet (type 0).  The stream has a ready latency of 1.
//
// Source: Video and Image Processing Suite User Guide (UG-VIPSUITE), "Frame Reader".
//
// Not handled: pixels that are wider than a word of the memory.

`default_nettype none

module alt_vip_vfr #(
    parameter BITS_PER_PIXEL_PER_COLOR_PLANE = 8,
    parameter NUMBER_OF_CHANNELS_IN_PARALLEL = 3,
    parameter MEM_PORT_WIDTH       = 256,
    parameter RMASTER_FIFO_DEPTH   = 64,
    parameter RMASTER_BURST_TARGET = 32,
    parameter BURST_BITS           = 6,
    // verilator lint_off UNUSED
    parameter MAX_IMAGE_WIDTH      = 640,
    parameter MAX_IMAGE_HEIGHT     = 480,
    // verilator lint_on UNUSED
    parameter BITS = BITS_PER_PIXEL_PER_COLOR_PLANE * NUMBER_OF_CHANNELS_IN_PARALLEL
) (
    input  wire                      clock,
    input  wire                      reset,
    input  wire                      master_clock,
    input  wire                      master_reset,

    input  wire [4:0]                slave_address,
    input  wire                      slave_write,
    input  wire [31:0]               slave_writedata,
    input  wire                      slave_read,
    output reg  [31:0]               slave_readdata,
    output wire                      slave_irq,

    output reg  [31:0]               master_address,
    output wire [BURST_BITS-1:0]     master_burstcount,
    output reg                       master_read,
    input  wire [MEM_PORT_WIDTH-1:0] master_readdata,
    input  wire                      master_readdatavalid,
    input  wire                      master_waitrequest,

    input  wire                      dout_ready,
    output reg                       dout_valid,
    output reg  [BITS-1:0]           dout_data,
    output reg                       dout_startofpacket,
    output reg                       dout_endofpacket
);
    localparam SYMBOL = BITS_PER_PIXEL_PER_COLOR_PLANE, SYMBOLS = NUMBER_OF_CHANNELS_IN_PARALLEL;
    localparam NIBBLES = 9, PIXELS = MEM_PORT_WIDTH / BITS;  // of a control packet, of a word
    localparam LOG2 = $clog2(RMASTER_FIFO_DEPTH);
    localparam LAST = PIXELS - 1;
    localparam [2:0] IDLE = 3'd0, CONTROL = 3'd1, VIDEO = 3'd2, SENDS = 3'd3, DRAINS = 3'd4;

    // ---- Registers --------------------------------------------------------
    reg  [31:0] registers [3:17];
    reg         go_q, enabled_q, done_q;
    reg  [2:0]  state_q;

    assign slave_irq = enabled_q && done_q;

    always @(posedge clock) begin
        if (slave_read)
            slave_readdata <= slave_address == 5'd0 ? {30'd0, enabled_q, go_q}
                            : slave_address == 5'd1 ? {31'd0, state_q != IDLE}
                            : slave_address == 5'd2 ? {30'd0, done_q, 1'b0}
                            : slave_address <= 5'd17 ? registers[slave_address] : 32'd0;
        if (slave_write && slave_address >= 5'd3 && slave_address <= 5'd17)
            registers[slave_address] <= slave_writedata;
    end

    // ---- A frame ----------------------------------------------------------
    wire [4:0]  first = registers[3][0] ? 5'd11 : 5'd4;  // of the frame's registers

    reg         asks_q;                  // changes with a frame
    reg  [31:0] base_q, words_q, left_q, popped_q;
    reg  [35:0] size_q;                  // nibbles of the control packet that are left, upper first
    reg  [3:0]  nibbles_q;
    reg  [7:0]  place_q;                 // of the pixel in its word

    wire [MEM_PORT_WIDTH-1:0] word;
    wire [LOG2:0]             words_here;
    wire        has_pixel = words_here != 0;
    wire        sends     = state_q == SENDS && dout_ready && has_pixel;
    wire        pops      = (sends && ({24'd0, place_q} == LAST || left_q == 32'd1))
                          || (state_q == DRAINS && popped_q != words_q && has_pixel);

    integer     n;
    // verilator lint_off BLKSEQ
    reg  [35:0] size;
    // verilator lint_on BLKSEQ

    always @(posedge clock) begin
        if (slave_write && slave_address == 5'd0) {enabled_q, go_q} <= slave_writedata[1:0];
        if (slave_write && slave_address == 5'd2 && slave_writedata[1]) done_q <= 1'b0;
        dout_valid <= 1'b0;
        dout_startofpacket <= 1'b0;
        dout_endofpacket   <= 1'b0;
        if (pops) popped_q <= popped_q + 32'd1;
        case (state_q)
            IDLE:
                if (go_q && dout_ready) begin
                    state_q   <= CONTROL;
                    asks_q    <= !asks_q;
                    base_q    <= registers[first];
                    words_q   <= registers[first + 5'd1];
                    left_q    <= registers[first + 5'd2];
                    size_q    <= {registers[first + 5'd4][15:0], registers[first + 5'd5][15:0],
                                  registers[first + 5'd6][3:0]};
                    nibbles_q <= NIBBLES;
                    place_q   <= 8'd0;
                    popped_q  <= 32'd0;
                    dout_valid <= 1'b1;
                    dout_startofpacket <= 1'b1;
                    dout_data <= 15;
                end
            CONTROL:
                if (dout_ready) begin
                    size = size_q;
                    for (n = 0; n < SYMBOLS; n = n + 1) begin
                        dout_data[SYMBOL * n +: SYMBOL] <= {{SYMBOL-4{1'b0}}, size[35:32]};
                        size = size << 4;
                    end
                    size_q     <= size;
                    dout_valid <= 1'b1;
                    nibbles_q  <= nibbles_q - SYMBOLS;
                    if (nibbles_q <= SYMBOLS) begin
                        dout_endofpacket <= 1'b1;
                        state_q <= VIDEO;
                    end
                end
            VIDEO:
                if (dout_ready) begin
                    dout_valid <= 1'b1;
                    dout_startofpacket <= 1'b1;
                    dout_endofpacket   <= left_q == 32'd0;
                    dout_data <= 0;
                    state_q   <= left_q == 32'd0 ? DRAINS : SENDS;
                end
            SENDS:
                if (sends) begin
                    dout_valid <= 1'b1;
                    dout_data  <= word[BITS * place_q +: BITS];
                    dout_endofpacket <= left_q == 32'd1;
                    left_q  <= left_q - 32'd1;
                    place_q <= {24'd0, place_q} == LAST ? 8'd0 : place_q + 8'd1;
                    if (left_q == 32'd1) state_q <= DRAINS;
                end
            DRAINS:  // words that no pixel has wanted
                if (popped_q == words_q) begin
                    state_q <= IDLE;
                    done_q  <= 1'b1;
                end
            default: state_q <= IDLE;
        endcase
        if (reset) begin
            {go_q, enabled_q, done_q, asks_q, dout_valid} <= 5'd0;
            state_q <= IDLE;
        end
    end

    // ---- Its words, in the memory's clock ---------------------------------
    reg  [2:0]    asked_q;
    reg  [31:0]   to_read_q, burst_q;
    reg  [LOG2:0] pending_q;   // words that were asked for and are not there yet
    wire [LOG2:0] used;
    wire [31:0]   burst = to_read_q < RMASTER_BURST_TARGET ? to_read_q : RMASTER_BURST_TARGET;
    wire          room  = {{31-LOG2{1'b0}}, used} + {{31-LOG2{1'b0}}, pending_q} + burst
                          <= (1 << LOG2);
    wire          taken = master_read && !master_waitrequest;

    assign master_burstcount = burst_q[BURST_BITS-1:0];

    always @(posedge master_clock) begin
        asked_q   <= {asked_q[1:0], asks_q};
        pending_q <= pending_q + (taken ? burst_q[LOG2:0] : {LOG2+1{1'b0}})
                     - {{LOG2{1'b0}}, master_readdatavalid};
        if (taken) begin
            master_read    <= 1'b0;
            master_address <= master_address + burst_q * (MEM_PORT_WIDTH / 8);
            to_read_q      <= to_read_q - burst_q;
        end else if (asked_q[2] != asked_q[1]) begin
            master_address <= base_q;
            to_read_q      <= words_q;
        end else if (!master_read && to_read_q != 32'd0 && room) begin
            master_read <= 1'b1;
            burst_q     <= burst;
        end
        if (master_reset) begin
            master_read <= 1'b0;
            asked_q     <= 3'd0;
            to_read_q   <= 32'd0;
            pending_q   <= 0;
        end
    end

    de1sim_vip_fifo #(.WIDTH(MEM_PORT_WIDTH), .LOG2(LOG2)) fifo (
        .in_clk_i(master_clock), .in_rst_i(master_reset), .write_i(master_readdatavalid),
        .data_i(master_readdata), .in_used_o(used),
        .out_clk_i(clock), .out_rst_i(reset), .read_i(pops), .data_o(word),
        .out_used_o(words_here)
    );
endmodule

`default_nettype wire
