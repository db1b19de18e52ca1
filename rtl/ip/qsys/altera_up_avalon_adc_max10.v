// altera_up_avalon_adc_max10.v - altera_up_avalon_adc for a DE10-Lite: the same registers, on the
// converter of its MAX 10, 0 to 5 V in 4,096 steps; channels 6 and 7 are 0
//
// Source: as altera_up_avalon_adc.v.

`default_nettype none

module altera_up_avalon_adc_max10 #(
    parameter CHANNELS  = 6,
    parameter MHZ       = 50,     // of the clock
    parameter PERIOD_PS = 20000
) (
    input  wire        clock,
    input  wire        reset,
    input  wire [2:0]  address,
    input  wire        read,
    input  wire        write,
    // verilator lint_off UNUSED
    input  wire [31:0] writedata,
    // verilator lint_on UNUSED
    output wire [31:0] readdata,
    output wire        waitrequest,
    output wire        adc_cs_n,  // of the other boards' converter
    output wire        adc_sclk,
    output wire        adc_din,
    // verilator lint_off UNUSED
    input  wire        adc_dout
    // verilator lint_on UNUSED
);
    reg         busy_q, once_q, continuous_q;  // once_q: a single round
    reg  [95:0] converted_q, values_q;
    reg  [7:0]  new_q;
    wire        fresh, ends;
    wire [2:0]  number;
    wire [11:0] value;
    wire        begins = write && address == 3'd0 && !busy_q;
    wire        more   = continuous_q && !busy_q && !begins;
    wire        less   = write && address == 3'd1 && !writedata[0] && continuous_q;

    de1sim_max10_adc #(.CHANNELS(CHANNELS), .MHZ(MHZ), .PERIOD_PS(PERIOD_PS)) rounds (
        .clock(clock), .reset(reset), .order(begins || more || less),
        .order_data(begins ? 2'd3 : {1'b0, more}), .fresh(fresh), .ends(ends), .number(number),
        .value(value)
    );

    assign {adc_cs_n, adc_sclk, adc_din} = 3'b100;
    assign waitrequest = read && busy_q && !continuous_q;
    assign readdata    = {16'd0, new_q[address] && continuous_q, 3'd0,
                          values_q[12 * address +: 12]};

    wire [95:0] with_value = (converted_q & ~(96'hfff << 12 * number)) |
                             ({84'd0, value} << 12 * number);

    always @(posedge clock) begin
        if (begins || more) {busy_q, once_q} <= {1'b1, begins};
        if (write && address == 3'd1) continuous_q <= writedata[0];
        if (fresh) converted_q <= with_value;
        if (read && continuous_q) new_q[address] <= 1'b0;
        if (fresh && ends) begin
            values_q <= with_value;
            new_q    <= 8'hff;
            if (once_q || !continuous_q) busy_q <= 1'b0;
        end
        if (reset) begin
            {busy_q, once_q, continuous_q} <= 3'd0;
            {converted_q, values_q, new_q} <= 200'd0;
        end
    end
endmodule

`default_nettype wire
