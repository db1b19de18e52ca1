// altera_up_avalon_adc_mega.v - the University Program's ADC controller without registers: converts
// again and again, CH0 to CH7 are what has come
//
//   MAX10 = 1  the converter of a DE10-Lite's MAX 10, its channels 1 to 6 as CH0 to CH5
//   MAX10 = 0  the LTC2308 of the other boards, by altera_up_avalon_adc
//
// Source: Intel FPGA University Program, ADC Controller for DE-Series Boards, and the Verilog that
// it generates.
//
// Not handled: that all channels change at once, at the end of a round.

`default_nettype none

module altera_up_avalon_adc_mega #(
    parameter MAX10      = 0,
    parameter CHANNELS   = 8,
    parameter HALF       = 4,     // clocks
    parameter CONVERSION = 200,   // clocks, 1.6 us or more
    parameter MHZ        = 50,    // of the clock
    parameter PERIOD_PS  = 20000
) (
    input  wire        CLOCK,
    input  wire        RESET,
    output wire        ADC_CS_N,
    output wire        ADC_SCLK,
    output wire        ADC_DIN,
    input  wire        ADC_DOUT,
    output wire [11:0] CH0,
    output wire [11:0] CH1,
    output wire [11:0] CH2,
    output wire [11:0] CH3,
    output wire [11:0] CH4,
    output wire [11:0] CH5,
    output wire [11:0] CH6,
    output wire [11:0] CH7
);
    reg  [95:0] values_q;
    reg         asked_q;  // to convert again and again
    wire        fresh;
    wire [2:0]  number;
    wire [11:0] value;

    assign {CH7, CH6, CH5, CH4, CH3, CH2, CH1, CH0} = values_q;

    always @(posedge CLOCK)
        if (RESET) begin
            asked_q  <= 1'b0;
            values_q <= 96'd0;
        end else begin
            asked_q <= 1'b1;
            if (fresh) values_q[12 * number +: 12] <= value;
        end

    // verilator lint_off PINMISSING
    // verilator lint_off UNUSED
    // verilator lint_off WIDTH
    generate
        if (MAX10 != 0) begin : max10
            assign {ADC_CS_N, ADC_SCLK, ADC_DIN} = 3'b100;
            de1sim_max10_adc #(
                .CHANNELS(CHANNELS), .MHZ(MHZ), .PERIOD_PS(PERIOD_PS)
            ) rounds (
                .clock(CLOCK), .reset(RESET), .order(!asked_q), .order_data(2'd1), .fresh(fresh),
                .number(number), .value(value)
            );
        end else begin : ltc2308
            reg  [2:0]  number_q;
            wire        waits;
            wire [31:0] read_data;
            assign fresh  = asked_q && !waits;
            assign number = number_q;
            assign value  = read_data[11:0];
            always @(posedge CLOCK) number_q <= RESET ? 3'd0 : number_q + {2'd0, fresh};
            altera_up_avalon_adc #(
                .CHANNELS(CHANNELS), .HALF(HALF), .CONVERSION(CONVERSION)
            ) converter (
                .clock(CLOCK), .reset(RESET), .address(asked_q ? number_q : 3'd1),
                .read(asked_q), .write(!asked_q && !RESET), .writedata(32'd1),
                .readdata(read_data), .waitrequest(waits),
                .adc_cs_n(ADC_CS_N), .adc_sclk(ADC_SCLK), .adc_din(ADC_DIN), .adc_dout(ADC_DOUT)
            );
        end
    endgenerate
    // verilator lint_on WIDTH
    // verilator lint_on UNUSED
    // verilator lint_on PINMISSING
endmodule

`default_nettype wire
