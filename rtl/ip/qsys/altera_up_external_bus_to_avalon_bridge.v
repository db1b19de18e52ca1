// altera_up_external_bus_to_avalon_bridge.v - the University Program's master, for one who asks
// from outside of the system: read or write stays until acknowledge, with which read_data is there
//
// Source: University Program, External Bus to Avalon Bridge.

`default_nettype none

module altera_up_external_bus_to_avalon_bridge #(
    parameter ADDRESS = 12,  // bits, of bytes
    parameter WIDTH   = 16
) (
    // verilator lint_off UNUSED
    input  wire               clk,
    input  wire               reset,
    // verilator lint_on UNUSED

    input  wire [WIDTH-1:0]   avalon_readdata,
    input  wire               avalon_waitrequest,
    output wire [ADDRESS-1:0] avalon_address,
    output wire [WIDTH/8-1:0] avalon_byteenable,
    output wire               avalon_read,
    output wire               avalon_write,
    output wire [WIDTH-1:0]   avalon_writedata,

    input  wire [ADDRESS-1:0] address,
    input  wire [WIDTH/8-1:0] byte_enable,
    input  wire               read,
    input  wire               write,
    input  wire [WIDTH-1:0]   write_data,
    output wire               acknowledge,
    output wire [WIDTH-1:0]   read_data
);
    assign avalon_address    = address;
    assign avalon_byteenable = byte_enable;
    assign avalon_read       = read;
    assign avalon_write      = write;
    assign avalon_writedata  = write_data;
    assign acknowledge       = (read || write) && !avalon_waitrequest;
    assign read_data         = avalon_readdata;
endmodule

`default_nettype wire
