// altera_avalon_i2c.v - Platform Designer's I2C master
//
//   0 TFR_CMD   write: a command to its FIFO: 9 STA, 8 STO, 7..1 AD, 0 RW_D; a byte is 7..0, and
//               the first after a START is the address, whose STO is not looked at
//   1 RX_DATA   read: the first byte of the other FIFO, which is gone then
//   2 CTRL      EN 0, BUS_SPEED 1, TFR_CMD_FIFO_THD 3..2, RX_DATA_FIFO_THD 5..4
//   3 ISER      the interrupts of ISR's bits
//   4 ISR       TX_READY 0: EN, and the commands are not more than 0, 1/4, 1/2 of the depth, depth
//               less 1, by TFR_CMD_FIFO_THD; RX_READY 1: the bytes are at least 1, 1/4, 1/2, all of
//               the depth; NACK_DET 2, ARBLOST_DET 3, RX_OVER 4: a 1 clears them
//   5 STATUS    0: at work, or enabled and never at work yet
//   6 TFR_CMD_FIFO_LVL, 7 RX_DATA_FIFO_LVL
//   8 SCL_LOW, 9 SCL_HIGH, 10 SDA_HOLD  in clocks
//
// While NACK_DET or ARBLOST_DET is set there are no commands: those that wait are gone, as are
// those that are written.  With USE_AV_ST commands and bytes are streams, not TFR_CMD and RX_DATA.
//
// Source: Embedded Peripherals IP User Guide, Avalon I2C Master Core; its drivers.

`default_nettype none

module altera_avalon_i2c #(
    parameter USE_AV_ST       = 0,
    parameter FIFO_DEPTH      = 4,
    parameter FIFO_DEPTH_LOG2 = 2
) (
    input  wire        clk,
    input  wire        rst_n,

    input  wire [3:0]  addr,
    input  wire        read,
    input  wire        write,
    // verilator lint_off UNUSED
    input  wire [31:0] writedata,  // no register has all
    // verilator lint_on UNUSED
    output reg  [31:0] readdata,
    output reg         intr,

    output wire [7:0]  src_data,
    output wire        src_valid,
    input  wire        src_ready,
    // verilator lint_off UNUSED
    input  wire [15:0] snk_data,   // a command is narrower
    // verilator lint_on UNUSED
    input  wire        snk_valid,
    output wire        snk_ready,

    input  wire        sda_in,
    input  wire        scl_in,
    output wire        sda_oe,
    output wire        scl_oe
);
    localparam [3:0] TFR_CMD = 4'd0, RX_DATA = 4'd1, CTRL = 4'd2, ISER = 4'd3, ISR = 4'd4,
                     STATUS = 4'd5, TFR_CMD_FIFO_LVL = 4'd6, RX_DATA_FIFO_LVL = 4'd7,
                     SCL_LOW = 4'd8, SCL_HIGH = 4'd9, SDA_HOLD = 4'd10;
    localparam [FIFO_DEPTH_LOG2:0] DEPTH = FIFO_DEPTH[FIFO_DEPTH_LOG2:0], ONE = 1, NONE = 0;

    reg  [5:0]  ctrl_q;
    reg  [4:0]  iser_q;
    reg  [15:0] low_q, high_q, hold_q;
    reg         nack_q, lost_q, over_q;

    // ---- The FIFOs --------------------------------------------------------
    wire        flushes = nack_q || lost_q;
    wire [9:0]  cmd;
    wire        cmd_taken, byte_valid, nack, lost, busy;
    wire [7:0]  got, first;
    wire [FIFO_DEPTH_LOG2:0] commands, bytes;

    de1sim_up_fifo #(.WIDTH(10), .LOG2(FIFO_DEPTH_LOG2)) cmd_fifo (
        .clk_i(clk), .rst_i(!rst_n || flushes),
        .push_i(USE_AV_ST != 0 ? snk_valid && snk_ready : write && addr == TFR_CMD),
        .wdata_i(USE_AV_ST != 0 ? snk_data[9:0] : writedata[9:0]),
        .pop_i(cmd_taken), .rdata_o(cmd), .count_o(commands));
    de1sim_up_fifo #(.WIDTH(8), .LOG2(FIFO_DEPTH_LOG2)) rx_fifo (
        .clk_i(clk), .rst_i(!rst_n), .push_i(byte_valid), .wdata_i(got),
        .pop_i(USE_AV_ST != 0 ? src_valid && src_ready : read && addr == RX_DATA),
        .rdata_o(first), .count_o(bytes));
    assign src_data  = first;
    assign src_valid = USE_AV_ST != 0 && bytes != NONE;
    assign snk_ready = USE_AV_ST != 0 && commands != DEPTH;

    de1sim_i2c_master master (
        .clk_i(clk), .rst_i(!rst_n), .enable_i(ctrl_q[0]),
        .low_i(low_q), .high_i(high_q), .hold_i(hold_q),
        .cmd_i(cmd), .cmd_valid_i(commands != NONE), .cmd_taken_o(cmd_taken), .stands_i(flushes),
        .busy_o(busy), .byte_valid_o(byte_valid), .byte_o(got), .nack_o(nack), .lost_o(lost),
        .scl_i(scl_in), .sda_i(sda_in), .scl_low_o(scl_oe), .sda_low_o(sda_oe));

    // ---- Registers --------------------------------------------------------
    function [FIFO_DEPTH_LOG2:0] part(input [1:0] threshold, input [FIFO_DEPTH_LOG2:0] least,
                                      input [FIFO_DEPTH_LOG2:0] most);
        case (threshold)
            2'd0:    part = least;
            2'd1:    part = DEPTH >> 2;
            2'd2:    part = DEPTH >> 1;
            default: part = most;
        endcase
    endfunction

    wire        tx_ready = ctrl_q[0] && commands <= part(ctrl_q[3:2], NONE, DEPTH - ONE);
    wire        rx_ready = bytes >= part(ctrl_q[5:4], ONE, DEPTH);
    wire [4:0]  isr      = {over_q, lost_q, nack_q, rx_ready, tx_ready};
    wire        clears   = write && addr == ISR;
    reg  [31:0] first_q;

    always @(posedge clk) begin
        intr <= (isr & iser_q) != 5'd0;
        if (clears) {over_q, lost_q, nack_q} <= {over_q, lost_q, nack_q} & ~writedata[4:2];
        if (byte_valid && bytes == DEPTH) over_q <= 1'b1;
        if (lost) lost_q <= 1'b1;
        if (nack) nack_q <= 1'b1;
        if (write)
            case (addr)
                CTRL:     ctrl_q <= writedata[5:0];
                ISER:     iser_q <= writedata[4:0];
                SCL_LOW:  low_q  <= writedata[15:0];
                SCL_HIGH: high_q <= writedata[15:0];
                SDA_HOLD: hold_q <= writedata[15:0];
                default:  ;
            endcase
        case (addr)
            RX_DATA:          first_q <= USE_AV_ST != 0 ? 32'd0 : {24'd0, first};
            CTRL:             first_q <= {26'd0, ctrl_q};
            ISER:             first_q <= {27'd0, iser_q};
            ISR:              first_q <= {27'd0, isr};
            STATUS:           first_q <= {31'd0, busy};
            TFR_CMD_FIFO_LVL: first_q <= {{31 - FIFO_DEPTH_LOG2{1'b0}}, commands};
            RX_DATA_FIFO_LVL: first_q <= {{31 - FIFO_DEPTH_LOG2{1'b0}}, bytes};
            SCL_LOW:          first_q <= {16'd0, low_q};
            SCL_HIGH:         first_q <= {16'd0, high_q};
            SDA_HOLD:         first_q <= {16'd0, hold_q};
            default:          first_q <= 32'd0;
        endcase
        readdata <= first_q;
        if (!rst_n) begin
            {ctrl_q, iser_q, nack_q, lost_q, over_q, intr} <= 15'd0;
            {low_q, high_q, hold_q} <= {3{16'd1}};
        end
    end
endmodule

`default_nettype wire
