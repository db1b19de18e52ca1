// ps2_ports.v - the two PS/2 ports of the DE1-SoC Computer; bit n belongs to number n
//
// Registers: ps2_port.v.

`default_nettype none

module ps2_ports (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire [1:0]  we_i,
    input  wire [3:0]  wstrb_i,
    input  wire [11:0] waddr_i,
    input  wire [31:0] wdata_i,
    input  wire [1:0]  re_i,
    input  wire        rlow_i,           // valid with re_i: the lowest byte is read, too
    input  wire [11:0] raddr_i,
    output wire [31:0] rdata_o,
    output wire        wait_o,
    output wire [1:0]  irq_o,

    input  wire [1:0]  ps2_clk_i,
    input  wire [1:0]  ps2_dat_i,
    output wire [1:0]  ps2_clk_low_o,    // 1 = pull low
    output wire [1:0]  ps2_dat_low_o,

    output wire        awake_o
);
    wire        tick, counting;          // the wires are sampled at each tick
    wire [1:0]  awake, wants_tick, waits;
    wire [63:0] rdata;

    prescaler ticks (
        .clk_i(clk_i), .rst_i(rst_i), .wanted_i(wants_tick != 2'd0), .tick_o(tick),
        .awake_o(counting)
    );

    assign rdata_o = rdata[31:0] | rdata[63:32];
    assign wait_o  = waits != 2'd0;
    assign awake_o = awake != 2'd0 || counting;

    genvar n;
    generate for (n = 0; n < 2; n = n + 1) begin : port
        ps2_port ps2 (
            .clk_i(clk_i), .rst_i(rst_i), .tick_i(tick), .we_i(we_i[n]), .wstrb_i(wstrb_i),
            .waddr_i(waddr_i), .wdata_i(wdata_i), .re_i(re_i[n]), .rlow_i(rlow_i),
            .raddr_i(raddr_i),
            .rdata_o(rdata[32 * n +: 32]), .wait_o(waits[n]), .irq_o(irq_o[n]),
            .ps2_clk_i(ps2_clk_i[n]), .ps2_dat_i(ps2_dat_i[n]),
            .ps2_clk_low_o(ps2_clk_low_o[n]), .ps2_dat_low_o(ps2_dat_low_o[n]),
            .awake_o(awake[n]), .wants_tick_o(wants_tick[n])
        );
    end endgenerate
endmodule

`default_nettype wire
