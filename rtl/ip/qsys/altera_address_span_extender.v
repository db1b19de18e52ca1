// altera_address_span_extender.v - a window of few addresses on a master's many
//
//   windowed_slave   address in words; its upper bits choose one of SUB_WINDOW_COUNT windows
//   expanded_master  address in bytes: the window's base, and the lower bits of the slave's
//   cntl             +8 n: base of window n, 64 bits, of which those within a window are 0
//
// After a reset the base of window 0 is MASTER_ADDRESS_DEF, the others' 0.
//
// Source: Quartus Prime User Guide: Platform Designer, Address Span Extender.

`default_nettype none

module altera_address_span_extender #(
    parameter        DATA_WIDTH           = 32,
    parameter        MASTER_ADDRESS_WIDTH = 32,
    parameter        SLAVE_ADDRESS_WIDTH  = 16,
    parameter        BURSTCOUNT_WIDTH     = 1,
    parameter        CNTL_ADDRESS_WIDTH   = 1,
    parameter        SUB_WINDOW_COUNT     = 1,
    parameter [63:0] MASTER_ADDRESS_DEF   = 64'd0
) (
    input  wire                            clk,
    input  wire                            reset,

    input  wire [SLAVE_ADDRESS_WIDTH-1:0]  avs_s0_address,
    input  wire                            avs_s0_read,
    output wire [DATA_WIDTH-1:0]           avs_s0_readdata,
    input  wire                            avs_s0_write,
    input  wire [DATA_WIDTH-1:0]           avs_s0_writedata,
    output wire                            avs_s0_readdatavalid,
    output wire                            avs_s0_waitrequest,
    input  wire [DATA_WIDTH/8-1:0]         avs_s0_byteenable,
    input  wire [BURSTCOUNT_WIDTH-1:0]     avs_s0_burstcount,

    output wire [MASTER_ADDRESS_WIDTH-1:0] avm_m0_address,
    output wire                            avm_m0_read,
    input  wire                            avm_m0_waitrequest,
    input  wire [DATA_WIDTH-1:0]           avm_m0_readdata,
    output wire                            avm_m0_write,
    output wire [DATA_WIDTH-1:0]           avm_m0_writedata,
    input  wire                            avm_m0_readdatavalid,
    output wire [DATA_WIDTH/8-1:0]         avm_m0_byteenable,
    output wire [BURSTCOUNT_WIDTH-1:0]     avm_m0_burstcount,

    // verilator lint_off UNUSED
    input  wire [CNTL_ADDRESS_WIDTH-1:0]   avs_cntl_address,
    input  wire                            avs_cntl_read,
    // verilator lint_on UNUSED
    output reg  [63:0]                     avs_cntl_readdata,
    input  wire                            avs_cntl_write,
    input  wire [63:0]                     avs_cntl_writedata,
    input  wire [7:0]                      avs_cntl_byteenable
);
    localparam        SHIFT  = $clog2(DATA_WIDTH / 8);
    localparam        CHOICE = SUB_WINDOW_COUNT == 1 ? 0 : CNTL_ADDRESS_WIDTH;
    localparam [63:0] WITHIN = (64'd1 << (SLAVE_ADDRESS_WIDTH + SHIFT - CHOICE)) - 64'd1;
    localparam [63:0] BASE   = ((64'd1 << MASTER_ADDRESS_WIDTH) - 64'd1) & ~WITHIN;

    reg  [63:0] base_q [0:SUB_WINDOW_COUNT-1];
    wire [63:0] place = {{(64 - SLAVE_ADDRESS_WIDTH){1'b0}}, avs_s0_address} << SHIFT;
    // Bits above the master's addresses are 0.
    // verilator lint_off UNUSED
    wire [63:0] address;
    // verilator lint_on UNUSED
    wire [CNTL_ADDRESS_WIDTH-1:0] written;
    integer     i;

    generate
        if (SUB_WINDOW_COUNT == 1) begin : one
            assign address = base_q[0] | (place & WITHIN);
            assign written = 1'b0;
        end else begin : several
            assign address = base_q[avs_s0_address[SLAVE_ADDRESS_WIDTH-1 -: CNTL_ADDRESS_WIDTH]]
                             | (place & WITHIN);
            assign written = avs_cntl_address;
        end
    endgenerate

    always @(posedge clk) begin
        avs_cntl_readdata <= base_q[written];
        for (i = 0; i < 64; i = i + 1)
            if (avs_cntl_write && avs_cntl_byteenable[i / 8])
                base_q[written][i] <= avs_cntl_writedata[i] && BASE[i];
        if (reset)
            for (i = 0; i < SUB_WINDOW_COUNT; i = i + 1)
                base_q[i] <= i == 0 ? MASTER_ADDRESS_DEF & BASE : 64'd0;
    end

    assign avm_m0_address       = address[MASTER_ADDRESS_WIDTH-1:0];
    assign avm_m0_read          = avs_s0_read;
    assign avm_m0_write         = avs_s0_write;
    assign avm_m0_writedata     = avs_s0_writedata;
    assign avm_m0_byteenable    = avs_s0_byteenable;
    assign avm_m0_burstcount    = avs_s0_burstcount;
    assign avs_s0_readdata      = avm_m0_readdata;
    assign avs_s0_readdatavalid = avm_m0_readdatavalid;
    assign avs_s0_waitrequest   = avm_m0_waitrequest;
endmodule

`default_nettype wire
