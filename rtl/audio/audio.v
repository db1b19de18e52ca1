// audio.v - the audio block: the DE1-SoC Computer's audio core, and the codec's set-up
//
//                             clk_i | clk_audio_i
//   LEFTDATA, RIGHTDATA --> 2 FIFOs of 128 --> send_fifo --> audio_serial --> DACDAT
//   LEFTDATA, RIGHTDATA <-- 2 FIFOs of 128 <-- come_fifo <-- audio_serial <-- ADCDAT
//   AV_CONFIG --> codec_setup --> I2C
//
// Samples are 32-bit words, of which the codec takes and gives bits 31:8; 7:0 read 0.
//
// A write to a full FIFO is dropped.  Once per frame a pair is sent if both FIFOs hold a sample,
// otherwise zeros are.  UNDERRUNS counts the frames of zeros that follow a frame with a pair, so a
// long silence counts once.  A sample that comes in while its FIFO is full is dropped, each side by
// itself.  Reading an empty FIFO gives the sample that was read last.  RI and WI are 0 without RE
// and WE.  While CW is 1 there is no room, so WSLC, WSRC and WI are 0.
//
// A write with any byte strobe pushes the whole word on wdata_i or clears UNDERRUNS; CONTROL
// changes by its byte lane.  A write with none does nothing.

`default_nettype none

module audio (
    input  wire        clk_i,          // 25 MHz
    input  wire        rst_i,
    input  wire        clk_audio_i,    // 128 per sample: 1.024 MHz, or 6.144 MHz with fast_i
    input  wire        rst_audio_i,
    input  wire        fast_i,         // 48,000 samples per second, not 8,000; constant

    input  wire        we_i,           // AUDIO, AV_CONFIG or CODEC is addressed
    input  wire [3:0]  wstrb_i,
    input  wire [11:0] waddr_i,
    input  wire [31:0] wdata_i,
    input  wire        re_i,
    input  wire [11:0] raddr_i,
    output reg  [31:0] rdata_o,        // one clock after re_i; 0 at other times
    output wire        hold_o,         // a write has not ended yet
    output reg         irq_o,          // level, one clock after its cause

    output wire        aud_bclk_o,
    output wire        aud_daclrck_o,
    output wire        aud_dacdat_o,
    output wire        aud_adclrck_o,
    input  wire        aud_adcdat_i,
    output wire        i2c_sclk_o,
    output wire        i2c_sdat_oe_o,  // 1 = pull low
    input  wire        i2c_sdat_i,     // asynchronous

    output wire        awake_o
);
    `include "regmap.vh"

    localparam [31:0] FAST_HZ  = 32'd48000;
    localparam [7:0] DEPTH     = AUDIO_FIFOSPACE_RESET[AUDIO_FIFOSPACE_WSLC_LSB +: 8];
    localparam [7:0] THRESHOLD = 8'd96;   // samples, or room for them, that raise RI or WI

    wire       config_awake, setup_awake;
    wire [3:0] fifos_awake;

    // ---- Writes and pops ---------------------------------------------------
    wire we = we_i && wstrb_i != 4'd0;
    wire we_left      = we && waddr_i == AUDIO_LEFTDATA[11:0];
    wire we_right     = we && waddr_i == AUDIO_RIGHTDATA[11:0];
    wire re_left      = re_i && raddr_i == AUDIO_LEFTDATA[11:0];
    wire re_right     = re_i && raddr_i == AUDIO_RIGHTDATA[11:0];

    reg ri_enable_q, wi_enable_q, hold_in_q, hold_out_q;

    always @(posedge clk_i) begin
        if (we_i && wstrb_i[0] && waddr_i == AUDIO_CONTROL[11:0]) begin
            ri_enable_q <= wdata_i[AUDIO_CONTROL_RE_LSB];
            wi_enable_q <= wdata_i[AUDIO_CONTROL_WE_LSB];
            hold_in_q   <= wdata_i[AUDIO_CONTROL_CR_LSB];
            hold_out_q  <= wdata_i[AUDIO_CONTROL_CW_LSB];
        end
        if (rst_i) begin
            ri_enable_q <= 1'b0;
            wi_enable_q <= 1'b0;
            hold_in_q   <= 1'b0;
            hold_out_q  <= 1'b0;
        end
    end

    // ---- The serial side, in a clock domain of its own ---------------------
    // One pair is received per frame; its arrival is the time to offer the next pair to send.
    wire        none_came, none_waits, serial_takes, serial_received, come_awake, sent_awake;
    wire [47:0] come, waiting, serial_pair;
    wire        frame = !none_came;
    wire [7:0]  left_out_count, right_out_count;
    wire [23:0] left_out, right_out;
    wire        left_out_empty, right_out_empty;
    wire        pair = !left_out_empty && !right_out_empty;
    wire        pop  = frame && pair;

    audio_serial serial (
        .clk_i(clk_audio_i), .rst_i(rst_audio_i),
        .bclk_o(aud_bclk_o), .lrck_o(aud_daclrck_o), .dacdat_o(aud_dacdat_o),
        .adcdat_i(aud_adcdat_i),
        .waits_i(!none_waits), .pair_i(waiting), .take_o(serial_takes),
        .received_o(serial_received), .pair_o(serial_pair)
    );
    assign aud_adclrck_o = aud_daclrck_o;

    // Neither can be full: each is emptied in the frame in which a pair came.
    // verilator lint_off PINCONNECTEMPTY
    dual_clock_fifo send_fifo (
        .wclk_i(clk_i), .wrst_i(rst_i), .push_i(pop), .wdata_i({left_out, right_out}),
        .full_o(), .wawake_o(sent_awake),
        .rclk_i(clk_audio_i), .rrst_i(rst_audio_i), .pop_i(serial_takes), .rdata_o(waiting),
        .empty_o(none_waits), .rawake_o()
    );
    dual_clock_fifo come_fifo (
        .wclk_i(clk_audio_i), .wrst_i(rst_audio_i), .push_i(serial_received),
        .wdata_i(serial_pair), .full_o(), .wawake_o(),
        .rclk_i(clk_i), .rrst_i(rst_i), .pop_i(1'b1), .rdata_o(come), .empty_o(none_came),
        .rawake_o(come_awake)
    );

    // ---- Samples -----------------------------------------------------------
    // The bits that the codec does not take are not stored; a full FIFO drops by itself.
    fifo #(.WIDTH(24)) left_out_fifo (
        .clk_i(clk_i), .rst_i(rst_i), .clear_i(hold_out_q), .push_i(we_left),
        .wdata_i(wdata_i[31:8]), .pop_i(pop), .rdata_o(left_out), .count_o(left_out_count),
        .full_o(), .empty_o(left_out_empty), .awake_o(fifos_awake[0])
    );
    fifo #(.WIDTH(24)) right_out_fifo (
        .clk_i(clk_i), .rst_i(rst_i), .clear_i(hold_out_q), .push_i(we_right),
        .wdata_i(wdata_i[31:8]), .pop_i(pop), .rdata_o(right_out), .count_o(right_out_count),
        .full_o(), .empty_o(right_out_empty), .awake_o(fifos_awake[1])
    );
    // verilator lint_on PINCONNECTEMPTY

    reg        paired_q;               // the frame before had a pair
    reg [31:0] underruns_q;

    always @(posedge clk_i) begin
        if (we && waddr_i == CODEC_UNDERRUNS[11:0]) underruns_q <= 32'd0;
        if (frame) begin
            paired_q <= pair;
            if (paired_q && !pair)
                underruns_q <= we && waddr_i == CODEC_UNDERRUNS[11:0] ? 32'd1
                               : underruns_q + 32'd1;
        end
        if (rst_i) begin
            paired_q    <= 1'b0;
            underruns_q <= 32'd0;
        end
    end

    wire [23:0] left_in, right_in;
    wire [7:0]  left_in_count, right_in_count;

    // verilator lint_off PINCONNECTEMPTY
    fifo #(.WIDTH(24)) left_in_fifo (
        .clk_i(clk_i), .rst_i(rst_i), .clear_i(hold_in_q), .push_i(frame), .wdata_i(come[47:24]),
        .pop_i(re_left), .rdata_o(left_in), .count_o(left_in_count), .full_o(),
        .empty_o(), .awake_o(fifos_awake[2])
    );
    fifo #(.WIDTH(24)) right_in_fifo (
        .clk_i(clk_i), .rst_i(rst_i), .clear_i(hold_in_q), .push_i(frame), .wdata_i(come[23:0]),
        .pop_i(re_right), .rdata_o(right_in), .count_o(right_in_count), .full_o(),
        .empty_o(), .awake_o(fifos_awake[3])
    );
    // verilator lint_on PINCONNECTEMPTY

    // ---- Codec -------------------------------------------------------------
    wire       codec_ready, codec_error;
    wire [3:0] codec_step;

    wire       config_restart, config_send, config_busy, config_nack, config_ready;
    wire [3:0] config_control;
    wire [6:0] config_slave;
    wire [7:0] config_address;
    wire [8:0] config_data;
    wire [15:0] config_word;

    av_config config_block (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i && waddr_i[11:4] == AV_CONFIG_BASE[11:4]),
        .wstrb_i(wstrb_i), .waddr_i(waddr_i), .wdata_i(wdata_i),
        .restart_o(config_restart), .send_o(config_send), .slave_o(config_slave),
        .word_o(config_word), .control_o(config_control), .address_o(config_address),
        .data_o(config_data), .busy_i(config_busy), .ready_o(config_ready), .hold_o(hold_o),
        .awake_o(config_awake)
    );

    codec_setup setup (
        .clk_i(clk_i), .rst_i(rst_i), .restart_i(config_restart), .fast_i(fast_i),
        .ready_o(codec_ready), .error_o(codec_error), .step_o(codec_step),
        .send_i(config_send), .send_slave_i(config_slave), .send_word_i(config_word),
        .busy_o(config_busy), .nack_o(config_nack),
        .sclk_o(i2c_sclk_o), .sdat_oe_o(i2c_sdat_oe_o), .sdat_i(i2c_sdat_i),
        .awake_o(setup_awake)
    );

    // ---- Reads and interrupt -----------------------------------------------
    function reached;                  // by a count of either channel
        input [7:0] left;
        input [7:0] right;
        reached = left >= THRESHOLD || right >= THRESHOLD;
    endfunction

    wire [7:0] left_room  = hold_out_q ? 8'd0 : DEPTH - left_out_count;
    wire [7:0] right_room = hold_out_q ? 8'd0 : DEPTH - right_out_count;
    wire       ri  = ri_enable_q && reached(left_in_count, right_in_count);
    wire       wi  = wi_enable_q && reached(left_room, right_room);
    wire       irq = ri || wi;

    always @(posedge clk_i) irq_o <= !rst_i && irq;

    assign awake_o = rdata_o != 32'd0 || irq != irq_o || frame || come_awake || sent_awake
                     || config_awake || setup_awake || fifos_awake != 4'd0;

    always @(posedge clk_i) begin
        rdata_o <= 32'd0;
        if (re_i) case (raddr_i)
            AUDIO_CONTROL[11:0]: begin
                rdata_o[AUDIO_CONTROL_RE_LSB] <= ri_enable_q;
                rdata_o[AUDIO_CONTROL_WE_LSB] <= wi_enable_q;
                rdata_o[AUDIO_CONTROL_CR_LSB] <= hold_in_q;
                rdata_o[AUDIO_CONTROL_CW_LSB] <= hold_out_q;
                rdata_o[AUDIO_CONTROL_RI_LSB] <= ri;
                rdata_o[AUDIO_CONTROL_WI_LSB] <= wi;
            end
            AUDIO_FIFOSPACE[11:0]: begin
                rdata_o[AUDIO_FIFOSPACE_RARC_LSB +: 8] <= right_in_count;
                rdata_o[AUDIO_FIFOSPACE_RALC_LSB +: 8] <= left_in_count;
                rdata_o[AUDIO_FIFOSPACE_WSRC_LSB +: 8] <= right_room;
                rdata_o[AUDIO_FIFOSPACE_WSLC_LSB +: 8] <= left_room;
            end
            AUDIO_LEFTDATA[11:0]:  rdata_o <= {left_in, 8'd0};
            AUDIO_RIGHTDATA[11:0]: rdata_o <= {right_in, 8'd0};
            CODEC_RATE[11:0]:      rdata_o <= fast_i ? FAST_HZ : CODEC_RATE_RESET;
            CODEC_STATUS[11:0]: begin
                rdata_o[CODEC_STATUS_READY_LSB]     <= codec_ready;
                rdata_o[CODEC_STATUS_ERROR_LSB]     <= codec_error;
                rdata_o[CODEC_STATUS_STEP_LSB +: 4] <= codec_step;
            end
            CODEC_UNDERRUNS[11:0]: rdata_o <= underruns_q;
            AV_CONFIG_CONTROL[11:0]: begin
                rdata_o[AV_CONFIG_CONTROL_RIE_LSB +: 2]    <= config_control[1:0];
                rdata_o[AV_CONFIG_CONTROL_DEVICE_LSB +: 2] <= config_control[3:2];
            end
            AV_CONFIG_STATUS[11:0]: begin
                rdata_o                           <= AV_CONFIG_STATUS_RESET;
                rdata_o[AV_CONFIG_STATUS_ACK_LSB] <= (config_nack && !config_send) || codec_error;
                rdata_o[AV_CONFIG_STATUS_RDY_LSB] <= config_ready;
                rdata_o[AV_CONFIG_STATUS_AIS_LSB] <= codec_ready;
            end
            AV_CONFIG_ADDRESS[11:0]: rdata_o <= {24'd0, config_address};
            AV_CONFIG_DATA[11:0]:    rdata_o <= {23'd0, config_data};
            default: ;
        endcase
    end
endmodule

`default_nettype wire
