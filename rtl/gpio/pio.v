// pio.v - parallel port in the register layout of the DE1-SoC Computer
//
//   +0 DATA   write: output register; read: the pins, whoever drives them
//   +4 DIR    1 = output                            (only with HAS_OUTPUT)
//   +8 MASK   1 = this bit's EDGE interrupts
//   +C EDGE   set when DATA falls; write 1 clears that bit, also of an edge in the same clock
//
// Source: Embedded Peripherals IP User Guide, PIO Core, and the Verilog that it generates for the
// DE1-SoC Computer.

`default_nettype none

module pio #(
    parameter WIDTH      = 32,
    parameter HAS_OUTPUT = 1,
    parameter HAS_EDGE   = 1
) (
    input  wire             clk_i,
    input  wire             rst_i,

    input  wire             we_i,
    input  wire [3:0]       wstrb_i,
    // Ports differ in width, and only the register's offset in the block is used.
    // verilator lint_off UNUSED
    input  wire [11:0]      waddr_i,
    input  wire [11:0]      raddr_i,
    input  wire [31:0]      wdata_i,
    // verilator lint_on UNUSED
    input  wire             re_i,
    output reg  [31:0]      rdata_o,
    output wire             irq_o,

    input  wire [WIDTH-1:0] pins_i,   // asynchronous
    output reg  [WIDTH-1:0] pins_o,
    output reg  [WIDTH-1:0] oe_o,

    output wire             awake_o
);
    `include "regmap.vh"
    `include "lanes.vh"

    // Ports are narrower than the bus.
    // verilator lint_off WIDTH
    function [WIDTH-1:0] written;
        input [WIDTH-1:0] old_bits;
        written = merged(old_bits, wdata_i, wstrb_i);
    endfunction
    function [WIDTH-1:0] ones;
        input [3:0] strobes;
        ones = wdata_i & lanes(strobes);
    endfunction
    // verilator lint_on WIDTH

    // ---- Pins -------------------------------------------------------------
    wire [WIDTH-1:0] data;
    reg  [WIDTH-1:0] data_was_q, mask_q, edge_q;

    wire pins_awake;
    sync #(.WIDTH(WIDTH)) pin_sync (
        .clk_i(clk_i), .async_i(pins_i), .sync_o(data), .awake_o(pins_awake)
    );

    assign irq_o   = (edge_q & mask_q) != {WIDTH{1'b0}};
    assign awake_o = rdata_o != 32'd0 || pins_awake || data != data_was_q;

    // ---- Registers: the offsets are JP1's, the widest of these ports -------
    // Reads come before writes, so that a simulator needs no copies of what both touch.
    always @(posedge clk_i) begin
        rdata_o <= 32'd0;
        // Zero-extension to the bus, for every width.
        // verilator lint_off WIDTH
        if (re_i) case (raddr_i[3:0])
            JP1_DATA[3:0]: rdata_o <= data;
            JP1_DIR[3:0]:  rdata_o <= oe_o;
            JP1_MASK[3:0]: rdata_o <= mask_q;
            default:       rdata_o <= edge_q;
        endcase
        // verilator lint_on WIDTH

        if (HAS_EDGE != 0)
            edge_q <= (edge_q | (data_was_q & ~data))
                      & ~(we_i && waddr_i[3:0] == JP1_EDGE[3:0] ? ones(wstrb_i) : {WIDTH{1'b0}});
        data_was_q <= data;
        if (we_i) case (waddr_i[3:0])
            JP1_DATA[3:0]: if (HAS_OUTPUT != 0) pins_o <= written(pins_o);
            JP1_DIR[3:0]:  if (HAS_OUTPUT != 0) oe_o <= written(oe_o);
            JP1_MASK[3:0]: if (HAS_EDGE != 0) mask_q <= written(mask_q);
            default: ;
        endcase
        if (rst_i) begin
            pins_o     <= {WIDTH{1'b0}};
            oe_o       <= {WIDTH{1'b0}};
            mask_q     <= {WIDTH{1'b0}};
            edge_q     <= {WIDTH{1'b0}};
            data_was_q <= {WIDTH{1'b0}};   // nothing falls at reset
        end
    end
endmodule

`default_nettype wire
