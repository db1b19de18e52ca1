// altera_up_avalon_audio.v - the University Program's audio core: samples to and from the codec,
// which is the master of BCLK and LRCK, in the left-justified format
//
//   avalon_audio_slave or streams --> 2 FIFOs of 128 --> DACDAT
//   avalon_audio_slave or streams <-- 2 FIFOs of 128 <-- ADCDAT
//
//   +0 control     RE bit 0, WE 1, CR 2, CW 3, RI 8, WI 9
//   +4 fifospace   WSLC 31:24, WSRC 23:16, RALC 15:8, RARC 7:0
//   +8 leftdata    +C rightdata
//
// A pair is sent if both FIFOs hold a sample when a frame begins, otherwise zeros are.  A sample
// that finds its FIFO full is lost, each side by itself.  RI and WI are there while a side has 96
// samples, or room for them.  While CR or CW is 1 these FIFOs are empty.
//
// Source: Intel FPGA University Program, Audio core for DE-Series Boards.

`default_nettype none

module altera_up_avalon_audio #(
    parameter audio_in  = 1, AUDIO_IN  = audio_in,
    parameter audio_out = 1, AUDIO_OUT = audio_out,
    parameter dw        = 32, DW       = dw,
    parameter is_mapped = 1, IS_MAPPED = is_mapped
) (
    input  wire          clk,
    input  wire          reset,

    input  wire [1:0]    address,
    input  wire          chipselect,
    input  wire          read,
    input  wire          write,
    input  wire [31:0]   writedata,
    output reg  [31:0]   readdata,
    output reg           irq,

    input  wire [DW-1:0] to_dac_left_channel_data,
    input  wire          to_dac_left_channel_valid,
    output wire          to_dac_left_channel_ready,
    input  wire [DW-1:0] to_dac_right_channel_data,
    input  wire          to_dac_right_channel_valid,
    output wire          to_dac_right_channel_ready,
    output wire [DW-1:0] from_adc_left_channel_data,
    output wire          from_adc_left_channel_valid,
    input  wire          from_adc_left_channel_ready,
    output wire [DW-1:0] from_adc_right_channel_data,
    output wire          from_adc_right_channel_valid,
    input  wire          from_adc_right_channel_ready,

    input  wire          AUD_BCLK,
    input  wire          AUD_ADCDAT,
    input  wire          AUD_ADCLRCK,
    output wire          AUD_DACDAT,
    input  wire          AUD_DACLRCK
);
    localparam [7:0] DEPTH = 8'd128, THRESHOLD = 8'd96;

    reg  re_q, we_q, cr_q, cw_q;
    wire writes = IS_MAPPED != 0 && chipselect && write;
    wire reads  = IS_MAPPED != 0 && chipselect && read;

    // ---- The codec's clocks ----
    reg [2:0] bclk_q, dac_q, adc_q;
    reg [1:0] adcdat_q;
    always @(posedge clk) begin
        bclk_q   <= {bclk_q[1:0], AUD_BCLK};
        dac_q    <= {dac_q[1:0], AUD_DACLRCK};
        adc_q    <= {adc_q[1:0], AUD_ADCLRCK};
        adcdat_q <= {adcdat_q[0], AUD_ADCDAT};
    end
    wire bclk_falls = bclk_q[2:1] == 2'b10, bclk_rises = bclk_q[2:1] == 2'b01;
    wire dac_left = dac_q[2:1] == 2'b01, dac_right = dac_q[2:1] == 2'b10;  // a side begins
    wire adc_moves = adc_q[2] != adc_q[1];

    // ---- To the codec ----
    wire [DW-1:0] left_out, right_out;
    wire [7:0]    left_out_count, right_out_count;
    reg  [DW-1:0] shift_q;
    reg           paired_q;              // this frame has a pair
    wire          pair = left_out_count != 8'd0 && right_out_count != 8'd0;

    assign AUD_DACDAT = AUDIO_OUT != 0 && shift_q[DW-1];
    always @(posedge clk) begin
        if (bclk_falls) shift_q <= shift_q << 1;
        if (dac_left) begin
            shift_q  <= pair ? left_out : {DW{1'b0}};
            paired_q <= pair;
        end
        if (dac_right) begin
            shift_q  <= paired_q ? right_out : {DW{1'b0}};
            paired_q <= 1'b0;
        end
        if (reset) begin
            shift_q  <= {DW{1'b0}};
            paired_q <= 1'b0;
        end
    end

    assign to_dac_left_channel_ready  = left_out_count != DEPTH;
    assign to_dac_right_channel_ready = right_out_count != DEPTH;
    de1sim_up_fifo #(.WIDTH(DW)) left_out_fifo (
        .clk_i(clk), .rst_i(reset || cw_q),
        .push_i(IS_MAPPED != 0 ? writes && address == 2'd2 : to_dac_left_channel_valid),
        .wdata_i(IS_MAPPED != 0 ? writedata[DW-1:0] : to_dac_left_channel_data),
        .pop_i(dac_left && pair), .rdata_o(left_out), .count_o(left_out_count)
    );
    de1sim_up_fifo #(.WIDTH(DW)) right_out_fifo (
        .clk_i(clk), .rst_i(reset || cw_q),
        .push_i(IS_MAPPED != 0 ? writes && address == 2'd3 : to_dac_right_channel_valid),
        .wdata_i(IS_MAPPED != 0 ? writedata[DW-1:0] : to_dac_right_channel_data),
        .pop_i(dac_right && paired_q), .rdata_o(right_out), .count_o(right_out_count)
    );

    // ---- From the codec ----
    wire [DW-1:0] left_in, right_in;
    wire [7:0]    left_in_count, right_in_count;
    reg  [DW-1:0] come_q;
    reg  [5:0]    bits_q;                // of the sample, still to come
    reg           side_q, whole_q;       // 1: the left one; it has come
    always @(posedge clk) begin
        whole_q <= 1'b0;
        if (bclk_rises && bits_q != 6'd0) begin
            come_q  <= {come_q[DW-2:0], adcdat_q[1]};
            bits_q  <= bits_q - 6'd1;
            whole_q <= bits_q == 6'd1;
        end
        if (adc_moves) begin
            side_q <= adc_q[1];
            bits_q <= DW[5:0];
        end
        if (reset) bits_q <= 6'd0;
    end

    assign from_adc_left_channel_data   = left_in;
    assign from_adc_right_channel_data  = right_in;
    assign from_adc_left_channel_valid  = left_in_count != 8'd0;
    assign from_adc_right_channel_valid = right_in_count != 8'd0;
    de1sim_up_fifo #(.WIDTH(DW)) left_in_fifo (
        .clk_i(clk), .rst_i(reset || cr_q),
        .push_i(AUDIO_IN != 0 && whole_q && side_q), .wdata_i(come_q),
        .pop_i(IS_MAPPED != 0 ? reads && address == 2'd2 : from_adc_left_channel_ready),
        .rdata_o(left_in), .count_o(left_in_count)
    );
    de1sim_up_fifo #(.WIDTH(DW)) right_in_fifo (
        .clk_i(clk), .rst_i(reset || cr_q),
        .push_i(AUDIO_IN != 0 && whole_q && !side_q), .wdata_i(come_q),
        .pop_i(IS_MAPPED != 0 ? reads && address == 2'd3 : from_adc_right_channel_ready),
        .rdata_o(right_in), .count_o(right_in_count)
    );

    // ---- Registers ----
    wire [7:0] left_room  = cw_q ? 8'd0 : DEPTH - left_out_count;
    wire [7:0] right_room = cw_q ? 8'd0 : DEPTH - right_out_count;
    wire       ri = re_q && (left_in_count >= THRESHOLD || right_in_count >= THRESHOLD);
    wire       wi = we_q && (left_room >= THRESHOLD || right_room >= THRESHOLD);

    always @(posedge clk) begin
        irq <= ri || wi;
        if (writes && address == 2'd0) {cw_q, cr_q, we_q, re_q} <= writedata[3:0];
        if (reads)
            case (address)
                2'd0:    readdata <= {22'd0, wi, ri, 4'd0, cw_q, cr_q, we_q, re_q};
                2'd1:    readdata <= {left_room, right_room, left_in_count, right_in_count};
                2'd2:    readdata <= {{(32-DW){1'b0}}, left_in};
                default: readdata <= {{(32-DW){1'b0}}, right_in};
            endcase
        if (reset) begin
            irq <= 1'b0;
            {cw_q, cr_q, we_q, re_q} <= 4'd0;
        end
    end
endmodule

`default_nettype wire
