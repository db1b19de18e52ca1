// codec_setup.v - sets up the WM8731 over I2C after reset and at each restart_i, and sends words
//
//   step  register                      step  register
//   0     R15 reset                     6     R4  analogue path: the DAC, no bypass
//   1     R6  power down                7     R5  digital path: not muted
//   2, 3  R0, R1 line in, 0 dB          8     R7  interface: I2S, 24 bits, slave
//   4, 5  R2, R3 headphones, 0 dB       9     R8  sampling: 8 or 48 kHz from 12.288 MHz
//                                       10    R9  active
//
// A word that is not acknowledged ends the set-up: error_o is high, step_o is the number of that
// word.  While ready_o is high, step_o is 10.  A restart waits for the end of the word on the wire,
// then begins at word 0.
//
// send_i sends one word to any slave, during which busy_o is high.  nack_o: the last such word was
// not acknowledged.
//
// Not handled: a reset of the FPGA while the codec pulls SDA low can spoil word 0; a restart helps.

`default_nettype none

module codec_setup (
    input  wire       clk_i,
    input  wire       rst_i,

    input  wire       restart_i,
    input  wire       fast_i,        // 48 kHz, not 8

    output reg        ready_o,
    output reg        error_o,
    output reg  [3:0] step_o,

    input  wire        send_i,       // not while busy_o
    input  wire [6:0]  send_slave_i, // its address; these two stable until then
    input  wire [15:0] send_word_i,
    output wire        busy_o,       // sets up, or sends
    output reg         nack_o,

    output wire       sclk_o,
    output wire       sdat_oe_o,
    input  wire       sdat_i,

    output wire       awake_o
);
    // ---- Register fields, by their names in the datasheet ------------------
    localparam [8:0] RESET      = 9'd0;          // R15
    localparam [8:0] MICPD      = 9'd1 << 1;     // R6: no microphone,
    localparam [8:0] OSCPD      = 9'd1 << 5;     //     XCK is the FPGA's, not a crystal's,
    localparam [8:0] CLKOUTPD   = 9'd1 << 6;     // CLKOUT is not connected
    localparam [8:0] LINVOL_0DB = 9'b1_0111;     // R0, R1; LINMUTE (bit 7) is 0
    localparam [8:0] HPVOL_0DB  = 9'b111_1001;   // R2, R3
    localparam [8:0] MUTEMIC    = 9'd1 << 1;     // R4; INSEL (bit 2), BYPASS (bit 3) are 0
    localparam [8:0] DACSEL     = 9'd1 << 4;
    localparam [8:0] DAC_ON     = 9'd0;          // R5: DACMU (bit 3) is 0, no de-emphasis
    localparam [8:0] FORMAT_I2S = 9'b10;         // R7; LRP (bit 4) and BCLKINV (bit 7) are 0
    localparam [8:0] IWL_24     = 9'b10 << 2;    //     MS (bit 6) is 0: slave
    localparam [8:0] SR_48K     = 9'b0000 << 2;  // R8: normal mode, BOSR = 0, 256 fs
    localparam [8:0] SR_8K      = 9'b0011 << 2;  //     1536 fs
    localparam [8:0] ACTIVE     = 9'd1;          // R9

    localparam [3:0] LAST_STEP = 4'd10;
    localparam [6:0] CODEC     = 7'h1a;          // on I2C: CSB is tied low

    function [15:0] word;
        input [3:0] step;
        input       fast;
        case (step)
            4'd0:    word = {7'd15, RESET};
            4'd1:    word = {7'd6, MICPD | OSCPD | CLKOUTPD};
            4'd2:    word = {7'd0, LINVOL_0DB};
            4'd3:    word = {7'd1, LINVOL_0DB};
            4'd4:    word = {7'd2, HPVOL_0DB};
            4'd5:    word = {7'd3, HPVOL_0DB};
            4'd6:    word = {7'd4, MUTEMIC | DACSEL};
            4'd7:    word = {7'd5, DAC_ON};
            4'd8:    word = {7'd7, FORMAT_I2S | IWL_24};
            4'd9:    word = {7'd8, fast ? SR_48K : SR_8K};
            default: word = {7'd9, ACTIVE};
        endcase
    endfunction

    // ---- One word after the other -----------------------------------------
    wire busy, done, nack, writer_awake;
    reg  restart_q;                  // when the word on the wire has ended
    reg  send_q;                     // a word more is to be sent
    reg  more_q;                     // it is on the wire
    wire sets_up = !ready_o && !error_o;
    wire start   = (sets_up || send_q) && !busy && !done && !restart_q;

    assign busy_o = sets_up || send_q;

    i2c_writer writer (
        .clk_i(clk_i), .rst_i(rst_i), .start_i(start), .slave_i(sets_up ? CODEC : send_slave_i),
        .word_i(sets_up ? word(step_o, fast_i) : send_word_i),
        .busy_o(busy), .done_o(done), .nack_o(nack),
        .sclk_o(sclk_o), .sdat_oe_o(sdat_oe_o), .sdat_i(sdat_i),
        .awake_o(writer_awake)
    );

    assign awake_o = start || restart_q || writer_awake;

    always @(posedge clk_i) begin
        if (send_i) begin
            send_q <= 1'b1;
            nack_o <= 1'b0;
        end
        if (done && more_q) begin
            send_q <= 1'b0;
            nack_o <= nack;
        end else if (done) begin
            if (nack) error_o <= 1'b1;
            else if (step_o == LAST_STEP) ready_o <= 1'b1;
            else step_o <= step_o + 4'd1;
        end
        if (start) more_q <= !sets_up;
        if (restart_i) restart_q <= 1'b1;
        if (restart_i || restart_q) begin
            ready_o <= 1'b0;
            error_o <= 1'b0;
        end
        if (restart_q && !busy) begin
            restart_q <= 1'b0;
            step_o    <= 4'd0;
        end
        if (rst_i) begin
            ready_o   <= 1'b0;
            error_o   <= 1'b0;
            step_o    <= 4'd0;
            restart_q <= 1'b0;
            send_q    <= 1'b0;
            nack_o    <= 1'b0;
        end
    end
endmodule

`default_nettype wire
