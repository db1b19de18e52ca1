// de1sim_avalon_width.v - commands of a master for a slave of another width
//
// Commands and answers as in de1sim_avalon_decoder.v.  For a slave that is narrower a command
// becomes one for each part that has a byte enabled, the lowest first, and at least one; with
// BURSTS a whole word becomes a burst of all its parts.  For a wider one its bytes are put where
// they belong, and words of a burst in one word of the slave are one command.

`default_nettype none

module de1sim_avalon_width #(
    parameter FROM       = 32,  // bits of the master: 8, 16, ... 1024
    parameter TO         = 16,  // of the slave: another
    parameter BURSTS     = 0,   // whether the slave takes them
    parameter MOST_LOG2  = 7,   // of answers that are on their way
    parameter FROM_BYTES = FROM / 8,
    parameter TO_BYTES   = TO / 8
) (
    input  wire                  clk_i,
    input  wire                  rst_i,

    input  wire                  valid_i,
    output wire                  ready_o,
    input  wire                  write_i,
    input  wire [15:0]           count_i,
    input  wire [31:0]           address_i,
    input  wire [FROM-1:0]       wdata_i,
    input  wire [FROM_BYTES-1:0] be_i,
    output wire                  rvalid_o,
    output wire [FROM-1:0]       rdata_o,

    output wire                  valid_o,
    input  wire                  ready_i,
    output wire                  write_o,
    output wire [15:0]           count_o,
    output wire [31:0]           address_o,
    output wire [TO-1:0]         wdata_o,
    output wire [TO_BYTES-1:0]   be_o,
    input  wire                  rvalid_i,
    input  wire [TO-1:0]         rdata_i
);
    localparam PARTS = FROM > TO ? FROM / TO : TO / FROM;
    localparam [15:0] MANY = PARTS[15:0];
    localparam [MOST_LOG2:0] MOST = 1 << MOST_LOG2;

    // ---- The parts whose answers are on their way ----
    // Which, and whether it is its command's last, or the last that a wider slave's answer is for.
    reg  [7:0]           parts_q [0:MOST-1];
    reg                  lasts_q [0:MOST-1];
    reg  [MOST_LOG2-1:0] first_q = 0, end_q = 0;
    reg  [MOST_LOG2:0]   pending_q = 0;
    wire                 taken;    // a part, by the slave or for the time being here
    wire                 answers;  // the oldest part
    wire [7:0]           part;
    wire                 last;
    wire [7:0]           answered = parts_q[first_q];

    assign write_o = write_i;

    always @(posedge clk_i) begin
        if (taken) begin
            parts_q[end_q] <= part;
            lasts_q[end_q] <= last;
            end_q          <= end_q + 1'b1;
        end
        if (answers) first_q <= first_q + 1'b1;
        pending_q <= pending_q + {{MOST_LOG2{1'b0}}, taken} - {{MOST_LOG2{1'b0}}, answers};
        if (rst_i) begin
            {first_q, end_q} <= 0;
            pending_q        <= 0;
        end
    end

    generate
        if (FROM > TO) begin : narrower
            reg             inside_q = 0;  // a burst has begun, and has not ended
            // A slave of one byte cannot be told to leave out a word of a burst.
            wire            whole = BURSTS != 0 && (TO_BYTES != 1 || !write_i)
                                    && (inside_q || count_i != 16'd1
                                        || be_i == {FROM_BYTES{1'b1}});
            reg [PARTS-1:0] done_q = 0;  // parts of this command that were sent
            reg [PARTS-1:0] open;        // that are left
            reg [7:0]       next;
            integer         n;
            always @* begin
                for (n = 0; n < PARTS; n = n + 1)
                    open[n] = (whole || be_i[TO_BYTES*n +: TO_BYTES] != {TO_BYTES{1'b0}})
                              && !done_q[n];
                if (!whole && be_i == {FROM_BYTES{1'b0}}) open = {{PARTS-1{1'b0}}, 1'b1} & ~done_q;
                next = 8'd0;
                for (n = PARTS - 1; n >= 0; n = n - 1) if (open[n]) next = n[7:0];
            end
            assign valid_o   = valid_i && pending_q != MOST;
            assign taken     = valid_o && ready_i;
            assign ready_o   = taken && last;
            assign answers   = rvalid_i;
            assign part      = next;
            // Where the slave takes no bursts a count says only that nobody may come between.
            assign count_o   = whole ? count_i * MANY - {8'd0, next}
                               : BURSTS != 0 ? 16'd1 : last ? count_i : 16'd2;
            assign last      = (open & (open - 1'b1)) == {PARTS{1'b0}};
            assign address_o = address_i + {24'd0, next} * TO_BYTES;
            assign wdata_o   = wdata_i[TO*next +: TO];
            assign be_o      = be_i[TO_BYTES*next +: TO_BYTES];

            reg [FROM-1:0] rdata_q = 0;
            reg [FROM-1:0] rdata;
            always @* begin
                rdata = rdata_q;
                rdata[TO*answered +: TO] = rdata_i;
            end
            assign rvalid_o = rvalid_i && lasts_q[first_q];
            assign rdata_o  = rdata;
            always @(posedge clk_i) begin
                if (taken)
                    done_q <= last ? {PARTS{1'b0}} : done_q | {{PARTS-1{1'b0}}, 1'b1} << next;
                if (ready_o) inside_q <= count_i != 16'd1;
                if (rvalid_i) rdata_q <= rvalid_o ? {FROM{1'b0}} : rdata;
                if (rst_i) begin
                    done_q   <= {PARTS{1'b0}};
                    inside_q <= 1'b0;
                    rdata_q <= {FROM{1'b0}};
                end
            end
        end else begin : wider
            wire [31:0] index = address_i / FROM_BYTES % PARTS;
            assign part = index[7:0];

            // ---- The slave's word: written with its last part, read with its first ----
            reg                 sent_q = 0;    // the word of the present burst has been read
            reg  [TO-1:0]       wdata_q = 0;   // what is to be written of it
            reg  [TO_BYTES-1:0] be_q = 0;
            wire                room  = pending_q != MOST;
            wire                waits = write_i ? !last : sent_q;   // nothing goes to the slave
            assign last      = {8'd0, part} == MANY - 16'd1 || count_i == 16'd1;
            assign valid_o   = valid_i && room && !waits;
            assign ready_o   = valid_i && room && (waits || ready_i);
            assign taken     = ready_o;
            assign count_o   = ({8'd0, part} + count_i - 16'd1) / MANY + 16'd1;
            assign address_o = address_i / TO_BYTES * TO_BYTES;

            reg  [TO-1:0]       wdata;
            reg  [TO_BYTES-1:0] be;
            integer             n;
            // verilator lint_off WIDTH
            always @* begin
                wdata = wdata_q;
                be    = be_q;
                for (n = 0; n < PARTS; n = n + 1) begin
                    if (n == part || (be_q == {TO_BYTES{1'b0}}))
                        wdata[FROM*n +: FROM] = wdata_i;
                    if (n == part || (!write_i && n > part && n < part + count_i))
                        be[FROM_BYTES*n +: FROM_BYTES] = be_i;
                end
            end
            // verilator lint_on WIDTH
            assign wdata_o = wdata;
            assign be_o    = be;

            // ---- Answers: one of the slave for all parts of its word; a part that waits to be
            // written has its own ----
            reg  [TO-1:0]        words_q [0:MOST-1];
            reg                  free_q [0:MOST-1];
            reg  [MOST_LOG2-1:0] put_q = 0, got_q = 0;
            reg  [MOST_LOG2:0]   stored_q = 0;
            wire                 free = free_q[first_q];
            wire [TO-1:0]        word = stored_q != 0 ? words_q[got_q] : rdata_i;
            wire                 used = rvalid_o && !free && lasts_q[first_q];
            assign answers  = rvalid_o;
            assign rvalid_o = pending_q != 0 && (free || stored_q != 0 || rvalid_i);
            assign rdata_o  = word[FROM*answered +: FROM];
            always @(posedge clk_i) begin
                if (taken) begin
                    sent_q         <= !write_i && !last;
                    free_q[end_q]  <= write_i && waits;
                    {wdata_q, be_q} <= write_i && waits ? {wdata, be} : {TO + TO_BYTES{1'b0}};
                end
                if (rvalid_i) begin
                    words_q[put_q] <= rdata_i;
                    put_q          <= put_q + 1'b1;
                end
                if (used) got_q <= got_q + 1'b1;
                stored_q <= stored_q + {{MOST_LOG2{1'b0}}, rvalid_i} - {{MOST_LOG2{1'b0}}, used};
                if (rst_i) begin
                    {sent_q, put_q, got_q, stored_q} <= 0;
                    be_q                             <= {TO_BYTES{1'b0}};
                end
            end
        end
    endgenerate
endmodule

`default_nettype wire
