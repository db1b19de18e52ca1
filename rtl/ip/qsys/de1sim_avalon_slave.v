// de1sim_avalon_slave.v - an Avalon-MM slave's signals, in its own timing
//
// Commands and answers as in de1sim_avalon_decoder.v; an answer comes a clock after the data.
//
//              ___     ___     ___     ___          SETUP 1, READ_WAIT 1, LATENCY 1
//   clk      _|   |___|   |___|   |___|   |___
//   address  =X=======================X=======
//                      _______________
//   read     _________|               |_______
//   readdata ===========================<data>
//
// With WAITREQUEST a transfer ends in the clock in which the slave does not hold it, and the fixed
// waits are not counted.  With READDATAVALID the slave says when its data are there; a read of
// several words, length_i, is one transfer.
//
// Source: Avalon Interface Specifications, Avalon Memory-Mapped Interfaces.

`default_nettype none

module de1sim_avalon_slave #(
    parameter WIDTH         = 32,
    parameter ADDRESS       = 1,  // bits
    parameter SHIFT         = 2,  // address in words: the bits of an address within a word; else 0
    parameter SETUP         = 0,
    parameter READ_WAIT     = 1,
    parameter WRITE_WAIT    = 0,
    parameter HOLD          = 0,
    parameter LATENCY       = 0,
    parameter WAITREQUEST   = 0,
    parameter READDATAVALID = 0,
    parameter MOST          = 128,  // of reads or, with bursts, words whose data are to come
    parameter READS         = 1,  // whether the slave can be read, and written: the answer to
    parameter WRITES        = 1,  // the others comes from here
    parameter BYTES         = WIDTH / 8
) (
    input  wire               clk_i,
    input  wire               rst_i,

    input  wire               valid_i,
    output wire               ready_o,
    input  wire               write_i,
    input  wire [31:0]        address_i,
    input  wire [WIDTH-1:0]   wdata_i,
    input  wire [BYTES-1:0]   be_i,
    input  wire [11:0]        length_i,
    output reg                rvalid_o,
    output reg  [WIDTH-1:0]   rdata_o,

    output wire [ADDRESS-1:0] address_o,
    output wire               chipselect_o,
    output wire               read_o,
    output wire               write_o,
    output wire               begintransfer_o,
    output wire [BYTES-1:0]   byteenable_o,
    output wire [WIDTH-1:0]   writedata_o,
    input  wire [WIDTH-1:0]   readdata_i,
    input  wire               waitrequest_i,
    input  wire               readdatavalid_i
);
    localparam [11:0] LIMIT = MOST;
    localparam LAST_READ  = SETUP + READ_WAIT;
    localparam LAST_WRITE = SETUP + WRITE_WAIT;

    // ---- The transfer ----
    // A write waits for the data of the reads before it, since answers keep their order.  In a
    // reset all wait.
    reg  [7:0] clock_q = 0;    // of this transfer
    reg  [11:0] pending_q = 0;  // reads whose data are to come, with READDATAVALID
    wire       known  = write_i ? WRITES != 0 : READS != 0;
    wire       orders = READDATAVALID == 0 || (write_i || !known ? pending_q == 12'd0
                                                                  : pending_q < LIMIT);
    wire       runs   = valid_i && orders && !rst_i;
    wire       acts   = runs && known;
    wire [7:0] last   = write_i ? LAST_WRITE : LAST_READ;
    wire       ends   = !known ? 1'b1
                      : WAITREQUEST != 0 ? clock_q >= SETUP && !waitrequest_i
                      : clock_q == last;
    wire       held   = clock_q > last && WAITREQUEST == 0;
    wire       done   = runs && (HOLD == 0 || !write_i || !known || WAITREQUEST != 0
                                 ? ends : clock_q == LAST_WRITE + HOLD);

    // Without a setup time the comparisons with it are constant.
    // verilator lint_off UNSIGNED
    assign ready_o         = done;
    assign address_o       = address_i[ADDRESS+SHIFT-1:SHIFT];
    assign chipselect_o    = acts;
    assign read_o          = acts && !write_i && clock_q >= SETUP;
    assign write_o         = acts && write_i && clock_q >= SETUP && !held;
    assign begintransfer_o = acts && clock_q == 8'd0;
    assign byteenable_o    = be_i;
    assign writedata_o     = wdata_i;
    // verilator lint_on UNSIGNED

    // ---- The answers, a clock after the data --------------------------------
    wire read_done  = done && acts && !write_i;
    wire other_done = done && !(acts && !write_i);
    wire data;    // the slave's data are there
    wire others;  // an answer without data, after those of the reads before it

    generate
        if (READDATAVALID != 0) begin : valid
            assign data   = readdatavalid_i;
            assign others = other_done;
        end else if (LATENCY == 0) begin : now
            assign data   = read_done;
            assign others = other_done;
        end else begin : later
            reg [LATENCY-1:0] line_q = 0, others_q = 0;
            // The oldest bit is dropped.
            // verilator lint_off WIDTH
            always @(posedge clk_i) begin
                line_q   <= rst_i ? {LATENCY{1'b0}} : {line_q, read_done};
                others_q <= rst_i ? {LATENCY{1'b0}} : {others_q, other_done};
            end
            // verilator lint_on WIDTH
            assign data   = line_q[LATENCY-1];
            assign others = others_q[LATENCY-1];
        end
    endgenerate

    always @(posedge clk_i) begin
        rvalid_o <= (data || others) && !rst_i;
        rdata_o  <= data ? readdata_i : {WIDTH{1'b0}};
    end

    always @(posedge clk_i) begin
        clock_q   <= !runs || done ? 8'd0 : clock_q != 8'hff ? clock_q + 8'd1 : clock_q;
        pending_q <= READDATAVALID == 0 ? 12'd0
                     : pending_q + (read_done ? length_i : 12'd0) - {11'd0, readdatavalid_i};
        if (rst_i) {clock_q, pending_q} <= 20'd0;
    end
endmodule

`default_nettype wire
