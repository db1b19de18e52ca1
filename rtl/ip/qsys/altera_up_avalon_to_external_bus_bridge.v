// altera_up_avalon_to_external_bus_bridge.v - the University Program's slave for a bus outside of
// the system
//
//              ___     ___     ___     ___     ___        address, rw (1: read), byte_enable and
//   clk      _|   |___|   |___|   |___|   |___|   |_      write_data are there with bus_enable;
//                      ___________________                read_data is taken with acknowledge
//   bus_enable _______|                   |_________
//                              ___________
//   acknowledge ______________|           |_________
//
// An access that has no acknowledge after 256 clocks ends without it.
//
// Source: University Program, Avalon to External Bus Bridge.

`default_nettype none

module altera_up_avalon_to_external_bus_bridge #(
    parameter ADDRESS = 11,  // bits, of words
    parameter SHIFT   = 1,   // of an address of a byte in a word
    parameter WIDTH   = 16
) (
    input  wire                     clk,
    input  wire                     reset,

    input  wire [ADDRESS-1:0]       avalon_address,
    input  wire [WIDTH/8-1:0]       avalon_byteenable,
    input  wire                     avalon_chipselect,
    input  wire                     avalon_read,
    input  wire                     avalon_write,
    input  wire [WIDTH-1:0]         avalon_writedata,
    output wire [WIDTH-1:0]         avalon_readdata,
    output wire                     avalon_waitrequest,
    output wire                     avalon_irq,

    input  wire                     acknowledge,
    input  wire                     irq,
    input  wire [WIDTH-1:0]         read_data,
    output wire [ADDRESS+SHIFT-1:0] address,
    output reg                      bus_enable,
    output reg  [WIDTH/8-1:0]       byte_enable,
    output reg                      rw,
    output reg  [WIDTH-1:0]         write_data
);
    reg  [ADDRESS-1:0] address_q;
    reg  [7:0]         clocks_q;
    wire               asks = avalon_chipselect && (avalon_read || avalon_write);
    wire               ends = bus_enable && (acknowledge || clocks_q == 8'd255);

    assign avalon_waitrequest = asks && !ends;
    assign avalon_readdata    = read_data;
    assign avalon_irq         = irq;

    generate
        if (SHIFT == 0) begin : bytes
            assign address = address_q;
        end else begin : words
            assign address = {address_q, {SHIFT{1'b0}}};
        end
    endgenerate

    always @(posedge clk) begin
        address_q   <= avalon_address;
        byte_enable <= avalon_byteenable;
        write_data  <= avalon_writedata;
        rw          <= avalon_read;
        bus_enable  <= asks && !ends;
        clocks_q    <= bus_enable && !ends ? clocks_q + 8'd1 : 8'd0;
        if (reset) {bus_enable, rw, clocks_q} <= 10'd0;
    end
endmodule

`default_nettype wire
