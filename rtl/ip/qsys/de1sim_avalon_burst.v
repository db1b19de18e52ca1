// de1sim_avalon_burst.v - joins the words of a burst into bursts that the slave takes
//
// Commands and answers as in de1sim_avalon_decoder.v.  A burst is cut at the slave's maximum; with
// BOUNDARIES so that each part begins at a multiple of its length, and with WRAPS where the slave
// would wrap.  A read goes to the slave with the first of its words; the others take their answers
// from here.  The words of a write keep the address and the length of their burst.
//
// Source: Avalon Interface Specifications, Avalon Memory-Mapped Interfaces.

`default_nettype none

module de1sim_avalon_burst #(
    parameter WIDTH      = 32,
    parameter MAX        = 16,  // words of the longest burst, a power of 2
    parameter BOUNDARIES = 0,   // as the slave's burstOnBurstBoundariesOnly
    parameter WRAPS      = 0,   // as its linewrapBursts: after MAX words
    parameter READS      = 1,   // whether it can be read
    parameter PENDING    = 64,  // most reads whose data are to come, at most 64
    parameter BYTES      = WIDTH / 8
) (
    input  wire             clk_i,
    input  wire             rst_i,

    input  wire             valid_i,
    output wire             ready_o,
    input  wire             write_i,
    input  wire [15:0]      count_i,
    input  wire [31:0]      address_i,
    input  wire [WIDTH-1:0] wdata_i,
    input  wire [BYTES-1:0] be_i,
    output wire             rvalid_o,
    output wire [WIDTH-1:0] rdata_o,

    output wire             valid_o,
    input  wire             ready_i,
    output wire             write_o,
    output wire [31:0]      address_o,
    output wire [11:0]      length_o,   // words of the burst
    output wire             first_o,    // this is its first
    output wire [WIDTH-1:0] wdata_o,
    output wire [BYTES-1:0] be_o,
    input  wire             rvalid_i,
    input  wire [WIDTH-1:0] rdata_i
);
    // ---- The length of a burst that begins ----
    // verilator lint_off WIDTH
    wire [15:0] place  = address_i / BYTES & (MAX - 1);
    wire [15:0] most   = WRAPS != 0 ? MAX - place : MAX;
    wire [15:0] fits   = READS == 0 && !write_i ? 16'd1 : count_i < most ? count_i : most;
    wire [15:0] lowest = place == 16'd0 ? MAX : place & (~place + 16'd1);
    reg  [15:0] whole;   // the largest power of 2 that fits, and divides the address
    integer     n;
    always @* begin
        whole = 16'd1;
        for (n = 1; n < 12; n = n + 1)
            if (16'd1 << n <= fits && 16'd1 << n <= lowest) whole = 16'd1 << n;
    end
    // verilator lint_on WIDTH
    wire [15:0] length = BOUNDARIES != 0 ? whole : fits;

    // ---- The burst under way ----
    reg  [11:0] left_q = 12'd0;      // of its words, after the present one
    reg  [11:0] length_q = 12'd0;
    reg  [31:0] address_q = 32'd0;
    reg         write_q = 1'b0;
    wire        goes_on = left_q != 12'd0;

    // ---- Answers: from the slave, for the words that were taken ----
    // An answer has a place here before its read is sent.
    localparam         LOG2  = $clog2(MAX) < 6 ? 7 : $clog2(MAX) + 1;
    localparam [LOG2:0] DEPTH = 1 << LOG2;
    reg  [WIDTH-1:0]  words_q [0:DEPTH-1];
    reg  [LOG2-1:0]   put_q = 0, got_q = 0;
    reg  [LOG2:0]     stored_q = 0;   // answers that no word has taken
    reg  [LOG2:0]     awaited_q = 0;  // of the slave, and those stored
    reg  [LOG2:0]     owed_q = 0;     // to words that were taken
    wire              takes = valid_i && ready_o;
    wire              sends = valid_o && ready_i;
    wire [15:0]       more  = {{15-LOG2{1'b0}}, awaited_q} + (write_i ? 16'd1 : length);

    assign rvalid_o = owed_q != 0 && (stored_q != 0 || rvalid_i);
    assign rdata_o  = stored_q != 0 ? words_q[got_q] : rdata_i;

    // ---- Reads whose data are to come: their lengths ----
    reg  [11:0] lengths_q [0:63];
    reg  [5:0]  oldest_q = 6'd0, newest_q = 6'd0;
    reg  [6:0]  reads_q = 7'd0;
    reg  [11:0] answered_q = 12'd0;   // words of the oldest
    wire        read_ends = rvalid_i && reads_q != 7'd0
                            && answered_q + 12'd1 == lengths_q[oldest_q];
    wire        read_goes = sends && !write_o;
    localparam [6:0] MOST = PENDING;
    wire        room = more <= {{15-LOG2{1'b0}}, DEPTH} && (write_i || reads_q < MOST);

    assign valid_o   = valid_i && room && (!goes_on || write_q);
    assign ready_o   = goes_on && !write_q ? room : room && ready_i;
    assign write_o   = write_i;
    assign address_o = goes_on ? address_q : address_i;
    assign length_o  = goes_on ? length_q : length[11:0];
    assign first_o   = !goes_on;
    assign wdata_o   = wdata_i;
    assign be_o      = be_i;

    wire [LOG2:0] asked = !sends ? 0 : write_o ? 1 : length_o[LOG2:0];

    always @(posedge clk_i) begin
        if (takes) begin
            if (!goes_on) begin
                left_q    <= length[11:0] - 12'd1;
                length_q  <= length[11:0];
                address_q <= address_i;
                write_q   <= write_i;
            end else left_q <= left_q - 12'd1;
        end
        if (rvalid_i) begin
            words_q[put_q] <= rdata_i;
            put_q          <= put_q + 1'b1;
        end
        if (rvalid_o) got_q <= got_q + 1'b1;
        stored_q  <= stored_q + {{LOG2{1'b0}}, rvalid_i} - {{LOG2{1'b0}}, rvalid_o};
        awaited_q <= awaited_q + asked - {{LOG2{1'b0}}, rvalid_o};
        owed_q    <= owed_q + {{LOG2{1'b0}}, takes} - {{LOG2{1'b0}}, rvalid_o};

        if (read_goes) begin
            lengths_q[newest_q] <= length_o;
            newest_q            <= newest_q + 6'd1;
        end
        if (rvalid_i && reads_q != 7'd0) answered_q <= read_ends ? 12'd0 : answered_q + 12'd1;
        if (read_ends) oldest_q <= oldest_q + 6'd1;
        reads_q <= reads_q + {6'd0, read_goes} - {6'd0, read_ends};
        if (rst_i) begin
            {left_q, answered_q}          <= 24'd0;
            {put_q, got_q}                <= 0;
            {stored_q, awaited_q, owed_q} <= 0;
            {oldest_q, newest_q}          <= 12'd0;
            reads_q                       <= 7'd0;
        end
    end
endmodule

`default_nettype wire
