// altera_avalon_mm_bridge.v - Platform Designer's bridge between two parts of a system: commands
// from s0 to m0, answers back
//
// With PIPELINE_COMMAND a command takes a clock, with PIPELINE_RESPONSE an answer; without, none.
//
// Source: Platform Designer User Guide, Avalon-MM Pipeline Bridge.

`default_nettype none

module altera_avalon_mm_bridge #(
    parameter DATA_WIDTH        = 32,
    parameter HDL_ADDR_WIDTH    = 10,
    parameter BURSTCOUNT_WIDTH  = 1,
    parameter PIPELINE_COMMAND  = 1,
    parameter PIPELINE_RESPONSE = 1,
    parameter BYTES             = DATA_WIDTH / 8
) (
    input  wire                      clk,
    input  wire                      reset,

    output wire                      s0_waitrequest,
    output wire [DATA_WIDTH-1:0]     s0_readdata,
    output wire                      s0_readdatavalid,
    input  wire [BURSTCOUNT_WIDTH-1:0] s0_burstcount,
    input  wire [DATA_WIDTH-1:0]     s0_writedata,
    input  wire [HDL_ADDR_WIDTH-1:0] s0_address,
    input  wire                      s0_write,
    input  wire                      s0_read,
    input  wire [BYTES-1:0]          s0_byteenable,
    input  wire                      s0_debugaccess,

    input  wire                      m0_waitrequest,
    input  wire [DATA_WIDTH-1:0]     m0_readdata,
    input  wire                      m0_readdatavalid,
    output wire [BURSTCOUNT_WIDTH-1:0] m0_burstcount,
    output wire [DATA_WIDTH-1:0]     m0_writedata,
    output wire [HDL_ADDR_WIDTH-1:0] m0_address,
    output wire                      m0_write,
    output wire                      m0_read,
    output wire [BYTES-1:0]          m0_byteenable,
    output wire                      m0_debugaccess
);
    localparam COMMAND = DATA_WIDTH + HDL_ADDR_WIDTH + BYTES + BURSTCOUNT_WIDTH + 1;

    wire [COMMAND-1:0] command = {s0_burstcount, s0_debugaccess, s0_byteenable, s0_address,
                                  s0_writedata};

    generate
        if (PIPELINE_COMMAND != 0) begin : with_command
            reg [COMMAND-1:0] command_q;
            reg               read_q, write_q;
            assign s0_waitrequest = (read_q || write_q) && m0_waitrequest;
            assign {m0_burstcount, m0_debugaccess, m0_byteenable, m0_address, m0_writedata} =
                   command_q;
            assign m0_read  = read_q;
            assign m0_write = write_q;
            always @(posedge clk) begin
                if (reset) {read_q, write_q} <= 2'b00;
                else if (!s0_waitrequest) {read_q, write_q} <= {s0_read, s0_write};
            end
            always @(posedge clk) if (!s0_waitrequest) command_q <= command;
        end else begin : without_command
            assign s0_waitrequest = m0_waitrequest;
            assign {m0_burstcount, m0_debugaccess, m0_byteenable, m0_address, m0_writedata} =
                   command;
            assign m0_read  = s0_read;
            assign m0_write = s0_write;
        end
        if (PIPELINE_RESPONSE != 0) begin : with_response
            reg [DATA_WIDTH-1:0] readdata_q;
            reg                  readdatavalid_q;
            assign s0_readdata      = readdata_q;
            assign s0_readdatavalid = readdatavalid_q;
            always @(posedge clk) begin
                if (reset) readdatavalid_q <= 1'b0;
                else readdatavalid_q <= m0_readdatavalid;
            end
            always @(posedge clk) readdata_q <= m0_readdata;
        end else begin : without_response
            assign s0_readdata      = m0_readdata;
            assign s0_readdatavalid = m0_readdatavalid;
        end
    endgenerate
endmodule

`default_nettype wire
