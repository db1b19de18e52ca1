// sdram_controller.v - words in and out of the board's SDRAM: IS42S16320D, 16 bits wide, CL 2
//
//   clock       _/0\_/1\_/2\_/3\_/4\_/5\_
//   take_o      =A=                         a read of an open row; the next read may go at 2
//   command         =RD=
//   dq                       =low==hi=      by the chip, whose clock is the inverse of clk_i
//   rvalid_o                          =D=
//
// A word is a burst of two columns.  A row stays open until another row of its bank is needed or
// all are closed for a refresh; there are 8,192 refreshes in 64 ms.  An access takes 2 clocks if
// its row is open, 3 if its bank has no open row, 4 if another row is open.  A write after a read
// waits 2 more for the bus.
//
// At 40 ns per clock the datasheet's times of a -7 part (tRCD and tRP 15 ns, tRAS 37, tRC 60,
// tRFC 60, tWR 14, tMRD 14) are 1 or 2 clocks, and the order in which commands can follow each
// other keeps them.
//
// Not handled: power-down and self-refresh.

`default_nettype none

module sdram_controller (
    input  wire        clk_i,          // 25 MHz
    input  wire        rst_i,

    input  wire        req_i,          // must not change until take_o
    input  wire        we_i,
    input  wire [23:0] index_i,        // of a word: row 23:11, bank 10:9, pair of columns 8:0
    input  wire [31:0] wdata_i,
    input  wire [3:0]  wstrb_i,
    output wire        take_o,
    output reg         rvalid_o,       // for one clock: the word of the oldest read
    output reg  [31:0] rdata_o,

    output reg         dram_cs_no,     // CKE is always high
    output reg         dram_ras_no,
    output reg         dram_cas_no,
    output reg         dram_we_no,
    output reg  [1:0]  dram_ba_o,
    output reg  [12:0] dram_addr_o,
    output reg  [1:0]  dram_dqm_o,
    output reg  [15:0] dram_dq_o,
    output reg         dram_dq_oe_o,
    input  wire [15:0] dram_dq_i,

    output wire        awake_o
);
    localparam [12:0] POWER_UP = 13'd5000;       // 200 us
    localparam [12:0] INTERVAL = 13'd192;        // 7.68 us: 8,192 refreshes in 62.9 ms
    localparam [12:0] MODE     = 13'h021;        // CL 2, sequential bursts of 2
    localparam [12:0] ALL      = 13'h400;        // A10
    localparam [3:0]  NOP = 4'b1111, ACTIVE = 4'b0011, READ = 4'b0101, WRITE = 4'b0100,
                      PRECHARGE = 4'b0010, REFRESH = 4'b0001, LOAD_MODE = 4'b0000;
    // Steps of the initialisation: close all, eight refreshes, the mode.
    localparam [3:0]  CLOSE = 4'd0, SET_MODE = 4'd9, READY = 4'd10;

    // ---- When to refresh --------------------------------------------------
    reg         refresh_q;                       // it is time for one
    wire        due, counting;

    // verilator lint_off PINCONNECTEMPTY
    countdown #(.WIDTH(13)) interval (
        .clk_i(clk_i), .load_i(due || rst_i), .value_i(rst_i ? POWER_UP : INTERVAL - 13'd1),
        .run_i(1'b1), .count_o(), .zero_o(due), .awake_o(counting)
    );
    // verilator lint_on PINCONNECTEMPTY

    // ---- Banks, and what the next command is ------------------------------
    reg  [3:0]  step_q;                          // of the initialisation
    reg         wait_q;                          // no command in this clock
    reg         opened_q;                        // the last command has opened a row: the access
    reg  [3:0]  open_q;                          //   to it has priority over all else
    reg  [51:0] rows_q;                          // the open ones
    reg  [2:0]  pipe_q;                          // a read 1, 2, 3 clocks ago
    wire [12:0] row   = index_i[23:11];
    wire [1:0]  bank  = index_i[10:9];
    wire        ready = step_q == READY;
    wire        hit   = open_q[bank] && rows_q[13 * bank +: 13] == row;
    wire        go    = !wait_q && ready && req_i && (opened_q || !refresh_q);

    assign take_o = go && hit && !(we_i && pipe_q != 3'd0);

    // ---- Commands ---------------------------------------------------------
    reg  [3:0]  command;
    reg  [12:0] address;
    always @* begin
        command = NOP;
        address = {4'd0, index_i[8:0]} << 1;
        if (take_o) begin
            command = we_i ? WRITE : READ;
        end else if (go && !hit) begin
            command = open_q[bank] ? PRECHARGE : ACTIVE;
            address = open_q[bank] ? 13'd0 : row;
        end else if (!wait_q && refresh_q && !(opened_q && req_i)) begin
            command = open_q != 4'd0 || step_q == CLOSE ? PRECHARGE
                      : step_q == SET_MODE ? LOAD_MODE : REFRESH;
            address = step_q == SET_MODE ? MODE : ALL;
        end
    end

    always @(posedge clk_i) begin
        {dram_cs_no, dram_ras_no, dram_cas_no, dram_we_no} <= command;
        if (command != NOP) begin
            dram_addr_o <= address;
            dram_ba_o   <= command == LOAD_MODE ? 2'd0 : bank;
        end
        wait_q   <= take_o || command == REFRESH || command == LOAD_MODE;
        opened_q <= command == ACTIVE;
        if (command == ACTIVE) begin
            open_q[bank] <= 1'b1;
            rows_q[13 * bank +: 13] <= row;
        end
        if (command == PRECHARGE) open_q <= address[10] ? 4'd0 : open_q & ~(4'd1 << bank);

        if (due) refresh_q <= 1'b1;
        else if (command == LOAD_MODE || (command == REFRESH && ready)) refresh_q <= 1'b0;
        if (!ready && command != NOP) step_q <= step_q + 4'd1;
        if (rst_i) begin
            {dram_cs_no, dram_ras_no, dram_cas_no, dram_we_no} <= NOP;
            refresh_q <= 1'b0;
            step_q    <= CLOSE;
            open_q    <= 4'd0;
            opened_q  <= 1'b0;
            wait_q    <= 1'b0;
        end
    end

    // ---- Data -------------------------------------------------------------
    reg        second_q;                         // the other half of a word is to be written
    reg [15:0] high_q, low_q;
    reg [1:0]  high_mask_q;

    always @(posedge clk_i) begin
        pipe_q   <= {pipe_q[1:0], take_o && !we_i};
        rvalid_o <= pipe_q[2];
        if (pipe_q[1]) low_q <= dram_dq_i;
        if (pipe_q[2]) rdata_o <= {dram_dq_i, low_q};

        second_q <= take_o && we_i;
        if (take_o && we_i) begin
            dram_dq_oe_o  <= 1'b1;
            dram_dq_o     <= wdata_i[15:0];
            dram_dqm_o    <= ~wstrb_i[1:0];
            high_q        <= wdata_i[31:16];
            high_mask_q   <= ~wstrb_i[3:2];
        end else if (second_q) begin
            dram_dq_o     <= high_q;
            dram_dqm_o    <= high_mask_q;
        end else if (dram_dq_oe_o) begin
            dram_dq_oe_o  <= 1'b0;
            dram_dqm_o    <= 2'b00;
        end
        if (rst_i) begin
            pipe_q       <= 3'd0;
            rvalid_o     <= 1'b0;
            second_q     <= 1'b0;
            dram_dq_oe_o <= 1'b0;
            dram_dqm_o   <= 2'b00;
        end
    end

    assign awake_o = {dram_cs_no, dram_ras_no, dram_cas_no, dram_we_no} != NOP || refresh_q
                     || wait_q || opened_q || pipe_q != 3'd0 || rvalid_o || second_q
                     || dram_dq_oe_o || counting;
endmodule

`default_nettype wire
