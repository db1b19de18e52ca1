// keypad_scan.v - 4 x 4 matrix scanner with whole-scan debounce
//
//            _____     _________________         One column is pulled low at a time, the others
//   col 0         |___|                 |___     float (two keys of one row never short two
//            _________     _________________     outputs).  Rows are read at the end of the slot,
//   col 1             |___|                      so the wire has the whole slot to settle.
//                     ^   ^
//                 row_ni sampled
//
// keys_o moves only after debounce_i equal scans in a row, all keys at once, so a reader never sees
// half of a chord.  One scan is 4 * SLOT_CYCLES clocks; a press appears debounce_i to debounce_i +
// 1 scans after its contact has stopped bouncing.
//
// Three keys on the corners of a rectangle close the path of the fourth (the matrix has no diodes),
// so a scan with four corners does not tell which keys are real.  While such a scan lasts, ghost_o
// is high and keys_o keeps its value, so no key is invented.  Once the scan is unambiguous again,
// keys_o follows it.

`default_nettype none

module keypad_scan #(
    parameter SLOT_CYCLES = 1250   // 50 us at 25 MHz, so 0.2 ms per scan
) (
    input  wire        clk_i,
    input  wire        rst_i,
    input  wire        run_i,      // scans while high; must be reset between two runs

    input  wire [7:0]  debounce_i, // equal scans that make a change; 0 counts as 1

    output wire [3:0]  col_low_o,  // pull this column low; bit c is column c from the left
    input  wire [3:0]  row_ni,     // asynchronous, pulled up; bit r is row r from the top

    output reg  [15:0] keys_o,     // bit 4 * r + c: key held
    output reg         ghost_o,

    output wire        awake_o
);
    localparam SLOT_W = $clog2(SLOT_CYCLES);
    // The constant fits: the width was computed from it.
    // verilator lint_off WIDTH
    localparam [SLOT_W-1:0] SLOT_LAST = SLOT_CYCLES - 1;
    // verilator lint_on WIDTH

    // ---- Rows into this clock domain --------------------------------------
    wire [3:0] row_n;
    wire       rows_awake;
    sync #(.WIDTH(4)) row_sync (
        .clk_i(clk_i), .async_i(row_ni), .sync_o(row_n), .awake_o(rows_awake)
    );

    // ---- Column walk ------------------------------------------------------
    reg       runs_q;
    reg [1:0] col_q;
    wire      last, counting;
    wire      starts   = run_i && !runs_q;
    wire      slot_end = runs_q && last;

    // The first slot is a clock shorter: the one in which it starts counts.
    // verilator lint_off PINCONNECTEMPTY
    countdown #(.WIDTH(SLOT_W)) slot (
        .clk_i(clk_i), .load_i(starts || slot_end),
        .value_i(SLOT_LAST - {{SLOT_W-1{1'b0}}, starts}), .run_i(runs_q), .count_o(),
        .zero_o(last), .awake_o(counting)
    );
    // verilator lint_on PINCONNECTEMPTY

    assign col_low_o = 4'b0001 << col_q;
    assign awake_o   = run_i != runs_q || scanned_q || rows_awake || counting;

    // ---- Debounce over whole scans ----------------------------------------
    reg [3:0]  rows0_q, rows1_q, rows2_q;   // columns read so far
    reg [15:0] last_q;                      // the previous whole scan, one nibble per column
    reg [7:0]  equal_q;                     // equal scans so far, saturating
    reg        scanned_q;                   // last_q and equal_q are new

    always @(posedge clk_i) begin
        scanned_q <= 1'b0;
        runs_q    <= run_i;
        if (slot_end) begin
            case (col_q)
                2'd0: rows0_q <= ~row_n;
                2'd1: rows1_q <= ~row_n;
                2'd2: rows2_q <= ~row_n;
                default: begin
                    if ({~row_n, rows2_q, rows1_q, rows0_q} != last_q) equal_q <= 8'd1;
                    else if (equal_q != 8'hff) equal_q <= equal_q + 8'd1;
                    last_q    <= {~row_n, rows2_q, rows1_q, rows0_q};
                    scanned_q <= 1'b1;
                end
            endcase
            col_q <= col_q + 2'd1;
        end
        if (rst_i) begin
            runs_q    <= 1'b0;
            col_q     <= 2'd0;
            scanned_q <= 1'b0;
            last_q    <= 16'd0;
            equal_q   <= 8'd0;
        end
    end

    // ---- Ghosts and the result --------------------------------------------
    // Two columns that have two rows in common are four corners of a rectangle.
    function two_common;
        input [3:0] a;
        input [3:0] b;
        two_common = (a & b & ((a & b) - 4'd1)) != 4'd0;
    endfunction

    function rectangle;
        input [15:0] scan;
        rectangle = two_common(scan[3:0], scan[7:4]) || two_common(scan[3:0], scan[11:8])
                    || two_common(scan[3:0], scan[15:12]) || two_common(scan[7:4], scan[11:8])
                    || two_common(scan[7:4], scan[15:12]) || two_common(scan[11:8], scan[15:12]);
    endfunction

    always @(posedge clk_i) begin
        if (scanned_q && equal_q >= debounce_i) begin
            ghost_o <= rectangle(last_q);
            if (!rectangle(last_q))   // from one nibble per column to one per row
                keys_o <= {last_q[15], last_q[11], last_q[7], last_q[3],
                           last_q[14], last_q[10], last_q[6], last_q[2],
                           last_q[13], last_q[9], last_q[5], last_q[1],
                           last_q[12], last_q[8], last_q[4], last_q[0]};
        end
        if (rst_i) begin
            keys_o  <= 16'd0;
            ghost_o <= 1'b0;
        end
    end
endmodule

`default_nettype wire
