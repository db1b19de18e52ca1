// de1sim_avalon_decoder.v - sends each command of a master to one of its slaves
//
// A command is valid_i with its address, until ready_o.  It has one answer, a read's with data, in
// a later clock, and answers come in the order of the commands.  So another slave's turn comes when
// all answers of the one before are there.
//
// count_i says how many words of a burst there are from this one on, each one word after the one
// before: 1 is a word alone, or the last.  A whole burst goes to the slave of its first word.
//
// hit_i has one bit for each slave, and one of them set: which one is computed from the address by
// the system's module, where a person can read it.

`default_nettype none

module de1sim_avalon_decoder #(
    parameter SLAVES = 2,
    parameter WIDTH  = 32
) (
    input  wire                    clk_i,
    input  wire                    rst_i,

    input  wire                    valid_i,
    output wire                    ready_o,
    input  wire [15:0]             count_i,
    input  wire [SLAVES-1:0]       hit_i,
    output wire                    rvalid_o,
    output wire [WIDTH-1:0]        rdata_o,

    output wire [SLAVES-1:0]       valid_o,
    input  wire [SLAVES-1:0]       ready_i,
    input  wire [SLAVES-1:0]       rvalid_i,
    input  wire [SLAVES*WIDTH-1:0] rdata_i
);
    localparam [7:0] MOST = 8'd128;

    reg [SLAVES-1:0] slave_q = 0;    // of the last command
    reg [7:0]        pending_q = 0;  // commands without their answer

    reg              goes_on_q = 0;  // the burst of the last command

    wire [SLAVES-1:0] hit = goes_on_q ? slave_q : hit_i;
    wire may   = pending_q == 8'd0 || (hit == slave_q && pending_q != MOST);
    wire taken = valid_i && ready_o;

    assign valid_o  = valid_i && may ? hit : {SLAVES{1'b0}};
    assign ready_o  = may && (hit & ready_i) != {SLAVES{1'b0}};
    assign rvalid_o = rvalid_i != {SLAVES{1'b0}};

    always @(posedge clk_i) begin
        if (taken) {slave_q, goes_on_q} <= {hit, count_i != 16'd1};
        pending_q <= pending_q + {7'd0, taken} - {7'd0, rvalid_o};
        if (rst_i) begin
            pending_q <= 8'd0;
            goes_on_q <= 1'b0;
        end
    end

    // ---- Answers ----
    genvar n;
    generate
        for (n = 0; n < SLAVES; n = n + 1) begin : slave
            wire [WIDTH-1:0] rdata;
            if (n == 0) begin : first
                assign rdata = rvalid_i[0] ? rdata_i[WIDTH-1:0] : {WIDTH{1'b0}};
            end else begin : others
                assign rdata = slave[n - 1].rdata
                             | (rvalid_i[n] ? rdata_i[WIDTH*n +: WIDTH] : {WIDTH{1'b0}});
            end
        end
    endgenerate
    assign rdata_o = slave[SLAVES - 1].rdata;
endmodule

`default_nettype wire
