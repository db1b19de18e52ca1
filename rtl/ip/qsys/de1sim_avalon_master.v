// de1sim_avalon_master.v - an Avalon-MM master's signals as commands
//
// Commands and answers as in de1sim_avalon_decoder.v.  A burst becomes a command for each word; one
// that wraps is two bursts behind here.  A master without readdatavalid waits for its data.
//
// Source: Avalon Interface Specifications, Avalon Memory-Mapped Interfaces.

`default_nettype none

module de1sim_avalon_master #(
    parameter WIDTH         = 32,
    parameter READDATAVALID = 0,
    parameter WRAP          = 0,  // bytes after which its bursts wrap, a power of 2; 0: they do not
    parameter BYTES         = WIDTH / 8
) (
    input  wire             clk_i,
    input  wire             rst_i,

    input  wire [31:0]      address_i,        // in bytes
    input  wire             read_i,
    input  wire             write_i,
    input  wire [BYTES-1:0] byteenable_i,
    input  wire [WIDTH-1:0] writedata_i,
    input  wire [10:0]      burstcount_i,     // 1 for a master without
    output wire             waitrequest_o,
    output wire             readdatavalid_o,
    output wire [WIDTH-1:0] readdata_o,

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
    // ---- Bursts: the words after the first -------------------------------
    reg  [10:0] left_q = 0;        // words of this burst that are to come
    reg         reads_q = 0;       // it reads, without the master
    reg  [31:0] next_q = 0;
    reg  [BYTES-1:0] be_q = 0;
    wire        goes_on = left_q != 11'd0;
    wire [10:0] words   = goes_on ? left_q : burstcount_i;
    wire [31:0] after   = address_o + BYTES;
    generate
        if (WRAP == 0) begin : up
            assign count_o = {5'd0, words};
        end else begin : wraps
            wire [31:0] most = (WRAP - (address_o & (WRAP - 1))) / BYTES;
            assign count_o = {21'd0, words} < most ? {5'd0, words} : most[15:0];
        end
    endgenerate

    // ---- Which answers are of reads ---------------------------------------
    reg         read_q [0:255];
    reg  [7:0]  first_q = 0, end_q = 0;
    wire        full  = end_q - first_q == 8'd192;
    reg         waits_q = 0;       // a read of a master without readdatavalid has been sent
    wire        reads = read_i || reads_q;
    wire        taken = valid_o && ready_i;
    wire        of_read = rvalid_i && read_q[first_q];

    assign valid_o   = !full && (reads_q || ((read_i || write_i) && !waits_q));
    assign write_o   = !reads_q && write_i;
    assign address_o = (goes_on ? next_q : address_i) & ~(BYTES - 1);
    assign wdata_o   = writedata_i;
    assign be_o      = reads_q ? be_q : byteenable_i;

    assign readdatavalid_o = of_read;
    assign readdata_o      = rdata_i;
    assign waitrequest_o   = READDATAVALID != 0 || !reads
                             ? reads_q || !taken : !(waits_q && of_read);

    always @(posedge clk_i) begin
        if (taken) begin
            read_q[end_q] <= !write_o;
            end_q         <= end_q + 8'd1;
            next_q        <= WRAP == 0 ? after
                                       : (address_o & ~(WRAP - 1)) | (after & (WRAP - 1));
            left_q        <= goes_on ? left_q - 11'd1 : burstcount_i - 11'd1;
            if (!write_o && READDATAVALID != 0) begin
                reads_q <= goes_on ? left_q != 11'd1 : burstcount_i > 11'd1;
                be_q    <= be_o;
            end
            if (!write_o && READDATAVALID == 0) waits_q <= 1'b1;
        end
        if (rvalid_i) first_q <= first_q + 8'd1;
        if (of_read) waits_q <= 1'b0;
        if (rst_i) begin
            left_q <= 11'd0;
            {first_q, end_q} <= 16'd0;
            {reads_q, waits_q} <= 2'b00;
        end
    end
endmodule

`default_nettype wire
