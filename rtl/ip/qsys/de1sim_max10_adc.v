// de1sim_max10_adc.v - rounds over the inputs of a DE10-Lite, by the converter of its MAX 10: what
// the University Program's controllers have inside on that board
//
//   order, order_data   as a write to the sequencer of altera_modular_adc: 1 again and again, 3
//                       once, 0 no longer
//   fresh               value is that of channel number, which is the converter's number + 1; ends:
//                       it is the round's last

`default_nettype none

module de1sim_max10_adc #(
    parameter CHANNELS  = 6,
    parameter MHZ       = 50,     // of the clock
    parameter PERIOD_PS = 20000
) (
    input  wire        clock,
    input  wire        reset,
    input  wire        order,
    input  wire [1:0]  order_data,
    output wire        fresh,
    output wire        ends,
    output wire [2:0]  number,
    output wire [11:0] value
);
    localparam [5:0] LAST_SLOT = CHANNELS[5:0] - 6'd1;

    wire       clk_10, locked;
    // verilator lint_off UNUSED
    wire [4:0] channel;  // 1 to 6
    // verilator lint_on UNUSED

    assign number = channel[2:0] - 3'd1;

    // verilator lint_off PINMISSING
    // verilator lint_off UNUSED
    // verilator lint_off WIDTH
    wire [5:0] clocks;
    assign clk_10 = clocks[0];
    altpll #(
        .inclk0_input_frequency(PERIOD_PS), .clk0_multiply_by(10), .clk0_divide_by(MHZ),
        .port_clk0("PORT_USED"), .width_clock(6)
    ) pll (
        .inclk({1'b0, clock}), .areset(1'b0), .pllena(1'b1), .clkena(6'h3f),
        .clk(clocks), .locked(locked)
    );
    altera_modular_adc #(
        .CLKDIV(2), .STORED(0), .LAST_SLOT(LAST_SLOT),
        .SLOTS({290'd0, 5'd6, 5'd5, 5'd4, 5'd3, 5'd2, 5'd1})
    ) converter (
        .clock_clk(clock), .reset_sink_reset_n(!reset), .adc_pll_clock_clk(clk_10),
        .adc_pll_locked_export(locked),
        .command_valid(1'b0), .command_channel(5'd0), .command_startofpacket(1'b0),
        .command_endofpacket(1'b0),
        .sequencer_csr_address(1'b0), .sequencer_csr_read(1'b0), .sequencer_csr_write(order),
        .sequencer_csr_writedata({30'd0, order_data}),
        .sample_store_csr_address(7'd0), .sample_store_csr_read(1'b0),
        .sample_store_csr_write(1'b0), .sample_store_csr_writedata(32'd0),
        .response_valid(fresh), .response_channel(channel), .response_data(value),
        .response_endofpacket(ends)
    );
    // verilator lint_on WIDTH
    // verilator lint_on UNUSED
    // verilator lint_on PINMISSING
endmodule

`default_nettype wire
