// keypad.v - the keypad block: scanner, event FIFO, registers, interrupt
//
//   scanner --keys--> one event per changed key --> FIFO of 16 --> EVENT
//
// Events of one scan come in the order of the key numbers.  An event that finds the FIFO full is
// lost and sets OVERFLOW; KEYS is right even then.  While CONTROL.EN = 0 the scanner, KEYS and the
// FIFO are held in reset and the pins are left to JP1.

`default_nettype none

module keypad #(
    parameter SLOT_CYCLES = 1250
) (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        we_i,
    input  wire [3:0]  wstrb_i,
    // Only the register's offset in the block and its bits are used.
    // verilator lint_off UNUSED
    input  wire [11:0] waddr_i,
    input  wire [11:0] raddr_i,
    input  wire [31:0] wdata_i,
    // verilator lint_on UNUSED
    input  wire        re_i,
    output reg  [31:0] rdata_o,
    output wire        irq_o,

    output reg         enable_o,    // the scanner owns the pins
    output wire [3:0]  col_low_o,
    input  wire [3:0]  row_ni,

    output wire        awake_o
);
    `include "regmap.vh"

    // ---- Scanner ----------------------------------------------------------
    reg  [7:0]  debounce_q;
    wire [15:0] keys;
    wire        ghost;
    reg         on_q;                        // enable_o of the clock before
    wire        off = rst_i || (on_q && !enable_o);
    wire        scanner_awake;

    always @(posedge clk_i) on_q <= enable_o && !rst_i;

    keypad_scan #(.SLOT_CYCLES(SLOT_CYCLES)) scanner (
        .clk_i(clk_i), .rst_i(off), .run_i(enable_o), .debounce_i(debounce_q),
        .col_low_o(col_low_o), .row_ni(row_ni), .keys_o(keys), .ghost_o(ghost),
        .awake_o(scanner_awake)
    );

    // ---- Events: a walk over the keys, one a clock -------------------------
    reg  [15:0] reported_q;   // keys according to the events so far
    reg  [3:0]  walk_q;
    wire        walks     = keys != reported_q;
    wire        event_now = walks && keys[walk_q] != reported_q[walk_q];
    wire        pop;
    wire [4:0]  event_head, event_count;
    wire        event_empty = event_count == 5'd0;

    always @(posedge clk_i) begin
        reported_q[walk_q] <= keys[walk_q];
        walk_q             <= walks ? walk_q + 4'd1 : 4'd0;
        if (off) begin
            walk_q     <= 4'd0;
            reported_q <= 16'd0;
        end
    end

    shift_fifo #(.WIDTH(5), .DEPTH_LOG2(4)) events (
        .clk_i(clk_i), .rst_i(off), .push_i(event_now), .wdata_i({keys[walk_q], walk_q}),
        .pop_i(pop), .rdata_o(event_head), .count_o(event_count)
    );

    // ---- Registers --------------------------------------------------------
    reg        overflow_q, ghost_q;
    reg  [2:0] mask_q;
    wire [2:0] status = {ghost_q, overflow_q, !event_empty};

    assign pop   = we_i && wstrb_i != 4'd0 && waddr_i[4:0] == KEYPAD_EVENT[4:0];
    assign irq_o = (status & mask_q) != 3'd0;

    assign awake_o = rdata_o != 32'd0 || on_q != enable_o || scanner_awake || walks
                     || walk_q != 4'd0 || (ghost && !ghost_q);

    always @(posedge clk_i) begin
        if (we_i && wstrb_i[0]) case (waddr_i[4:0])
            KEYPAD_CONTROL[4:0]:  enable_o   <= wdata_i[KEYPAD_CONTROL_EN_LSB];
            KEYPAD_DEBOUNCE[4:0]: debounce_q <= wdata_i[7:0];
            KEYPAD_MASK[4:0]:     mask_q     <= wdata_i[2:0];
            KEYPAD_STATUS[4:0]: begin
                if (wdata_i[KEYPAD_STATUS_OVERFLOW_LSB]) overflow_q <= 1'b0;
                if (wdata_i[KEYPAD_STATUS_GHOST_LSB]) ghost_q <= 1'b0;
            end
            default: ;
        endcase
        if (event_now && event_count[4]) overflow_q <= 1'b1;
        if (ghost) ghost_q <= 1'b1;
        if (rst_i) begin
            enable_o   <= 1'b0;
            debounce_q <= KEYPAD_DEBOUNCE_RESET[7:0];
            mask_q     <= 3'd0;
            overflow_q <= 1'b0;
            ghost_q    <= 1'b0;
        end
    end

    always @(posedge clk_i) begin
        rdata_o <= 32'd0;
        if (re_i) case (raddr_i[4:0])
            KEYPAD_CONTROL[4:0]:  rdata_o[KEYPAD_CONTROL_EN_LSB] <= enable_o;
            KEYPAD_STATUS[4:0]: begin
                rdata_o[KEYPAD_STATUS_EVENT_LSB]      <= !event_empty;
                rdata_o[KEYPAD_STATUS_OVERFLOW_LSB]   <= overflow_q;
                rdata_o[KEYPAD_STATUS_GHOST_LSB]      <= ghost_q;
                rdata_o[KEYPAD_STATUS_GHOST_HELD_LSB] <= ghost;
                rdata_o[KEYPAD_STATUS_COUNT_LSB +: 5] <= event_count;
            end
            KEYPAD_KEYS[4:0]:     rdata_o <= {16'd0, keys};
            KEYPAD_EVENT[4:0]: if (!event_empty) begin
                rdata_o[KEYPAD_EVENT_KEY_LSB +: 4] <= event_head[3:0];
                rdata_o[KEYPAD_EVENT_PRESSED_LSB]  <= event_head[4];
                rdata_o[KEYPAD_EVENT_VALID_LSB]    <= 1'b1;
            end
            KEYPAD_DEBOUNCE[4:0]: rdata_o <= {24'd0, debounce_q};
            KEYPAD_MASK[4:0]:     rdata_o <= {29'd0, mask_q};
            default: ;
        endcase
    end
endmodule

`default_nettype wire
