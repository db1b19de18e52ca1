// de1sim_avalon_arbiter.v - lets several masters have one slave, in turn
//
// Commands and answers as in de1sim_avalon_decoder.v.  A master that goes on asking keeps its turn
// for as many commands as it has shares, a burst being one; then the next one that asks has it.
// Nobody comes between the words of a burst.

`default_nettype none
// A turn has bits for many masters.
// verilator lint_off WIDTH

module de1sim_avalon_arbiter #(
    parameter                 MASTERS   = 2,
    parameter                 WIDTH     = 32,
    parameter [8*MASTERS-1:0] SHARES    = {MASTERS{8'd1}},  // the first master's in bits 7:0
    parameter                 MOST_LOG2 = 7,                // of answers that are on their way
    parameter                 BYTES     = WIDTH / 8
) (
    input  wire                     clk_i,
    input  wire                     rst_i,

    input  wire [MASTERS-1:0]       valid_i,
    output wire [MASTERS-1:0]       ready_o,
    input  wire [MASTERS-1:0]       write_i,
    input  wire [16*MASTERS-1:0]    count_i,
    input  wire [32*MASTERS-1:0]    address_i,
    input  wire [WIDTH*MASTERS-1:0] wdata_i,
    input  wire [BYTES*MASTERS-1:0] be_i,
    output wire [MASTERS-1:0]       rvalid_o,

    output wire                     valid_o,
    input  wire                     ready_i,
    output wire                     write_o,
    output wire [15:0]              count_o,
    output wire [31:0]              address_o,
    output wire [WIDTH-1:0]         wdata_o,
    output wire [BYTES-1:0]         be_o,
    input  wire                     rvalid_i
);
    // ---- Whose turn it is ----
    reg [7:0] turn_q = 0;   // of the last command, or of one that waits
    reg [7:0] left_q = 0;   // of its shares
    reg       inside_q = 0; // a burst has begun, and has not ended
    reg [7:0] turn;
    reg       found;
    integer   n;

    // The bits of masters after the present one come first.
    always @* begin
        turn  = turn_q;
        found = valid_i[turn_q] && (left_q != 8'd0 || inside_q);
        for (n = 0; n < MASTERS; n = n + 1)
            if (!found && !inside_q && n > turn_q && valid_i[n]) begin
                turn  = n[7:0];
                found = 1'b1;
            end
        for (n = 0; n < MASTERS; n = n + 1)
            if (!found && !inside_q && valid_i[n]) begin
                turn  = n[7:0];
                found = 1'b1;
            end
    end

    // ---- Who has asked for the answers that are on their way ----
    localparam [MOST_LOG2:0] MOST = 1 << MOST_LOG2;
    reg  [7:0]           owners_q [0:MOST-1];
    reg  [MOST_LOG2-1:0] first_q = 0, end_q = 0;
    reg  [MOST_LOG2:0]   pending_q = 0;
    wire                 taken = valid_o && ready_i;
    wire                 ends  = taken && count_o == 16'd1;

    assign valid_o   = found && pending_q != MOST;
    assign write_o   = write_i[turn];
    assign count_o   = count_i[16*turn +: 16];
    assign address_o = address_i[32*turn +: 32];
    assign wdata_o   = wdata_i[WIDTH*turn +: WIDTH];
    assign be_o      = be_i[BYTES*turn +: BYTES];

    genvar m;
    generate
        for (m = 0; m < MASTERS; m = m + 1) begin : master
            assign ready_o[m]  = ready_i && valid_o && turn == m;
            assign rvalid_o[m] = rvalid_i && owners_q[first_q] == m;
        end
    endgenerate

    always @(posedge clk_i) begin
        if (valid_o) begin
            turn_q <= turn;
            if (turn != turn_q || left_q == 8'd0)
                left_q <= SHARES[8*turn +: 8] - {7'd0, ends};
            else
                left_q <= left_q - {7'd0, ends};
        end
        if (taken) begin
            owners_q[end_q] <= turn;
            end_q           <= end_q + 1'b1;
            inside_q        <= !ends;
        end
        if (rvalid_i) first_q <= first_q + 1'b1;
        pending_q <= pending_q + taken - rvalid_i;
        if (rst_i) begin
            {first_q, end_q} <= 0;
            pending_q        <= 0;
            left_q           <= 8'd0;
            inside_q         <= 1'b0;
        end
    end
// verilator lint_on WIDTH
endmodule

`default_nettype wire
