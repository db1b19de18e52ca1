// altera_up_avalon_audio_and_video_config.v - the University Program's set-up of the codec over I2C
//
//   +0 control   a write of bit 0 sets the codec up as at reset; device bits 17:16: 0 the codec,
//                1 the video decoder
//   +4 status    ack bit 0: 1 = the last word was not acknowledged; ready bit 1; set up bit 8
//   +8 address   the device's register
//   +C data      what is written there; waits while a word is on its way
//
// After reset, with SETS_UP, ten words go to the codec: power, both inputs, both headphones,
// analogue and digital path, format, sampling, active.  A bit of I2C takes four QUARTERs of clocks.
//
// Source: Intel FPGA University Program, Audio/Video Configuration core for DE-Series Boards.
//
// Not handled: reading a device's registers; setting the video decoder up, which needs none.

`default_nettype none

module altera_up_avalon_audio_and_video_config #(
    parameter SETS_UP  = 1,
    parameter ANALOG   = 0,
    parameter FORMAT   = 0,
    parameter SAMPLING = 0,
    parameter QUARTER  = 125
) (
    input  wire        clk,
    input  wire        reset,
    input  wire [1:0]  address,
    // verilator lint_off UNUSED
    input  wire [3:0]  byteenable,
    input  wire        read,
    input  wire        write,
    input  wire [31:0] writedata,
    // verilator lint_on UNUSED
    output wire [31:0] readdata,
    output wire        waitrequest,
    inout  wire        I2C_SDAT,
    output wire        I2C_SCLK
);
    localparam [3:0] WORDS = 4'd10;
    localparam [6:0] CODEC = 7'h1a, DECODER = 7'h20;

    function [15:0] word;
        input [3:0] n;
        case (n)
            4'd0:    word = {7'd6, 9'h000};
            4'd1:    word = {7'd0, 9'h017};
            4'd2:    word = {7'd1, 9'h017};
            4'd3:    word = {7'd2, 9'h079};
            4'd4:    word = {7'd3, 9'h079};
            4'd5:    word = {7'd4, ANALOG[8:0]};
            4'd6:    word = {7'd5, 9'h006};
            4'd7:    word = {7'd7, FORMAT[8:0]};
            4'd8:    word = {7'd8, SAMPLING[8:0]};
            default: word = {7'd9, 9'h001};
        endcase
    endfunction

    reg [1:0]  device_q;
    reg [7:0]  address_q;
    reg [8:0]  data_q;
    reg [3:0]  step_q;                   // of the set-up; WORDS: done
    reg        failed_q, by_hand_q;      // a word was refused; of data_q

    // A word: START, 27 cells of bits and acknowledgements, STOP.
    reg [31:0] count_q;                  // clocks of the quarter
    reg [1:0]  quarter_q;
    reg [4:0]  cell_q;
    reg [26:0] bits_q;
    reg        busy_q, scl_q, sda_q;

    wire       sets_up = SETS_UP != 0 && step_q != WORDS;
    wire       writes  = write && !waitrequest;
    wire       sends   = writes && address == 2'd3;

    assign waitrequest = write && address == 2'd3 && (busy_q || sets_up);
    assign readdata    = address == 2'd0 ? {14'd0, device_q, 16'd0}
                       : address == 2'd1 ? {23'd0, step_q == WORDS, 6'd0, !busy_q, failed_q}
                       : address == 2'd2 ? {24'd0, address_q} : {23'd0, data_q};
    assign I2C_SCLK    = scl_q;
    assign I2C_SDAT    = sda_q ? 1'bz : 1'b0;

    wire [26:0] by_hand = device_q == 2'd0
                        ? {CODEC, 2'b01, address_q[6:0], writedata[8], 1'b1, writedata[7:0], 1'b1}
                        : {DECODER, 2'b01, address_q, 1'b1, writedata[7:0], 1'b1};
    wire [15:0] next    = word(step_q);
    wire        ack     = cell_q == 5'd9 || cell_q == 5'd18 || cell_q == 5'd27;

    always @(posedge clk) begin
        if (!busy_q) begin
            count_q   <= 32'd0;
            quarter_q <= 2'd0;
            cell_q    <= 5'd0;
            if (sends || sets_up) begin
                busy_q    <= 1'b1;
                failed_q  <= 1'b0;
                by_hand_q <= sends;
                bits_q    <= sends ? by_hand : {CODEC, 2'b01, next[15:8], 1'b1, next[7:0], 1'b1};
            end
        end else if (count_q != QUARTER - 1) begin
            count_q <= count_q + 32'd1;
        end else begin
            count_q   <= 32'd0;
            quarter_q <= quarter_q + 2'd1;
            case (quarter_q)
                2'd0: if (cell_q != 5'd0) sda_q <= cell_q != 5'd28 && bits_q[26];
                2'd1: if (cell_q == 5'd0) sda_q <= 1'b0; else scl_q <= 1'b1;
                2'd2: if (ack && I2C_SDAT) failed_q <= 1'b1;
                default:
                    if (cell_q == 5'd28) begin
                        sda_q  <= 1'b1;
                        busy_q <= 1'b0;
                        if (!by_hand_q) step_q <= step_q + 4'd1;
                    end else begin
                        scl_q  <= 1'b0;
                        cell_q <= cell_q + 5'd1;
                        if (cell_q != 5'd0) bits_q <= {bits_q[25:0], 1'b1};
                    end
            endcase
        end
        if (writes && address == 2'd0) begin
            if (byteenable[2]) device_q <= writedata[17:16];
            if (byteenable[0] && writedata[0] && !busy_q) step_q <= 4'd0;
        end
        if (writes && address == 2'd2 && byteenable[0]) address_q <= writedata[7:0];
        if (sends) data_q <= writedata[8:0];
        if (reset) begin
            device_q  <= 2'd0;
            address_q <= 8'd0;
            data_q    <= 9'd0;
            step_q    <= 4'd0;
            failed_q  <= 1'b0;
            busy_q    <= 1'b0;
            scl_q     <= 1'b1;
            sda_q     <= 1'b1;
        end
    end
endmodule

`default_nettype wire
