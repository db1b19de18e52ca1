// axi_registers.v - the processor's lightweight bridge (AXI3) as registers of 32 bits
//
//   write_o  in this clock: data_o goes to the register number_o
//   number_o selects what read_i shows
//
// A burst is its words one after the other.  One access at a time, reads first.

module axi_registers (
    input  wire        clk,
    input  wire        rst_n,

    input  wire [11:0] awid,
    input  wire [20:0] awaddr,
    input  wire        awvalid,
    output wire        awready,
    input  wire [31:0] wdata,
    input  wire        wlast,
    input  wire        wvalid,
    output wire        wready,
    output wire [11:0] bid,
    output wire        bvalid,
    input  wire        bready,

    input  wire [11:0] arid,
    input  wire [20:0] araddr,
    input  wire [3:0]  arlen,
    input  wire        arvalid,
    output wire        arready,
    output wire [11:0] rid,
    output wire [31:0] rdata,
    output wire        rlast,
    output wire        rvalid,
    input  wire        rready,

    output wire        write_o,
    output wire [2:0]  number_o,
    output wire [31:0] data_o,
    input  wire [31:0] read_i
);
    localparam IDLE = 2'd0, READS = 2'd1, WRITES = 2'd2, ANSWERS = 2'd3;

    reg [1:0]  state;
    reg [11:0] id;
    reg [2:0]  number;
    reg [3:0]  left;  // words of a read after this one

    assign arready = state == IDLE;
    assign awready = state == IDLE && !arvalid;
    assign wready  = state == WRITES;
    assign bvalid  = state == ANSWERS;
    assign rvalid  = state == READS;
    assign rlast   = left == 0;
    assign rdata   = read_i;
    assign rid     = id;
    assign bid     = id;

    assign write_o  = wvalid && wready;
    assign number_o = number;
    assign data_o   = wdata;

    always @(posedge clk)
        if (!rst_n) begin
            state <= IDLE;
        end else case (state)
            IDLE:
                if (arvalid) begin
                    state <= READS;
                    id <= arid;
                    number <= araddr[4:2];
                    left <= arlen;
                end else if (awvalid) begin
                    state <= WRITES;
                    id <= awid;
                    number <= awaddr[4:2];
                end
            READS:
                if (rready) begin
                    number <= number + 3'd1;
                    left <= left - 4'd1;
                    if (rlast) state <= IDLE;
                end
            WRITES:
                if (wvalid) begin
                    number <= number + 3'd1;
                    if (wlast) state <= ANSWERS;
                end
            ANSWERS:
                if (bready) state <= IDLE;
        endcase
endmodule
