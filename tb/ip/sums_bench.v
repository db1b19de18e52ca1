// sums_bench.v - sums of many numbers, squares, roots, shifts and words joined, at common inputs

`default_nettype none

module sums_bench (
    input  wire        clock_i, enable_i, aclr_i, gate_i, aset_i, direction_i, drive_i,
    input  wire [23:0] a_i,
    input  wire [2:0]  distance_i,

    output wire [13:0] four_o,                // as a wizard writes it
    output wire [7:0]  low_o,                 // narrower than the sum
    output wire [9:0]  signed_o,
    output wire [7:0]  top_o,                 // of 4 + 2 * 2 + 2 bits, two clocks later
    output wire [15:0] wide_o,                // wider than the sum
    output wire [23:0] square_o,
    output wire [15:0] signed_square_o,
    output wire [3:0]  top_square_o,          // a clock later
    output wire [11:0] root_o,
    output wire [12:0] remainder_o,
    output wire [3:0]  odd_root_o,            // three clocks later
    output wire [4:0]  odd_remainder_o,
    output wire [7:0]  abs_o, inv_o, and_o, or_o, xor_o, latch_o,
    output wire        abs_overflow_o,
    output wire [7:0]  logical_o, arithmetic_o, later_o,
    output wire [6:0]  rotate_o,
    output wire [1:0]  logical_lost_o, arithmetic_lost_o,   // overflow, underflow
    output wire [7:0]  bus_o, from_bus_o
);
    parallel_add four (
        .data({a_i[5:0], a_i[17:0], a_i}), .result(four_o), .aclr(), .clken(), .clock());
    defparam
        four.msw_subtract = "NO",
        four.pipeline = 0,
        four.representation = "UNSIGNED",
        four.result_alignment = "LSB",
        four.shift = 0,
        four.size = 4,
        four.width = 12,
        four.widthr = 14;
    parallel_add #(.WIDTH(8), .SIZE(3), .WIDTHR(8)) low (.data(a_i), .result(low_o));
    parallel_add #(
        .WIDTH(8), .SIZE(3), .WIDTHR(10), .REPRESENTATION("SIGNED"), .MSW_SUBTRACT("YES")
    ) negative (.data(a_i), .result(signed_o));
    parallel_add #(
        .WIDTH(4), .SIZE(3), .WIDTHR(8), .SHIFT(2), .PIPELINE(2), .RESULT_ALIGNMENT("MSB")
    ) top (
        .clock(clock_i), .clken(enable_i), .aclr(aclr_i), .data(a_i[11:0]), .result(top_o));
    parallel_add #(
        .WIDTH(4), .SIZE(3), .WIDTHR(16), .SHIFT(1), .REPRESENTATION("SIGNED")
    ) wide (.data(a_i[11:0]), .result(wide_o));

    altsquare square (
        .data(a_i[11:0]), .result(square_o), .aclr(1'b0), .clock(1'b1), .ena(1'b1), .sclr(1'b0));
    defparam
        square.data_width = 12,
        square.lpm_type = "ALTSQUARE",
        square.pipeline = 0,
        square.representation = "UNSIGNED",
        square.result_width = 24;
    altsquare #(.DATA_WIDTH(8), .RESULT_WIDTH(16), .REPRESENTATION("SIGNED")) signed_square (
        .data(a_i[7:0]), .result(signed_square_o));
    altsquare #(.DATA_WIDTH(8), .RESULT_WIDTH(4), .PIPELINE(1)) top_square (
        .clock(clock_i), .ena(enable_i), .aclr(aclr_i), .sclr(1'b0), .data(a_i[7:0]),
        .result(top_square_o));

    altsqrt root (
        .radical(a_i), .q(root_o), .remainder(remainder_o), .aclr(), .clk(), .ena());
    defparam
        root.pipeline = 0,
        root.q_port_width = 12,
        root.r_port_width = 13,
        root.width = 24;
    altsqrt #(.WIDTH(7), .Q_PORT_WIDTH(4), .R_PORT_WIDTH(5), .PIPELINE(3)) odd_root (
        .clk(clock_i), .ena(enable_i), .aclr(aclr_i), .radical(a_i[6:0]), .q(odd_root_o),
        .remainder(odd_remainder_o));

    lpm_abs #(.LPM_WIDTH(8)) absolute (
        .data(a_i[7:0]), .result(abs_o), .overflow(abs_overflow_o));
    lpm_inv #(.LPM_WIDTH(8)) inverse (.data(a_i[7:0]), .result(inv_o));
    lpm_and #(.LPM_WIDTH(8), .LPM_SIZE(3)) all_of (.data(a_i), .result(and_o));
    lpm_or #(.LPM_WIDTH(8), .LPM_SIZE(3)) any_of (.data(a_i), .result(or_o));
    lpm_xor #(.LPM_WIDTH(8), .LPM_SIZE(3)) odd_of (.data(a_i), .result(xor_o));
    lpm_latch #(.LPM_WIDTH(8), .LPM_AVALUE("77")) hold (
        .data(a_i[7:0]), .gate(gate_i), .aclr(aclr_i), .aset(aset_i), .q(latch_o));

    lpm_clshift #(.LPM_WIDTH(8), .LPM_WIDTHDIST(3)) logical (
        .data(a_i[7:0]), .distance(distance_i), .direction(direction_i), .result(logical_o),
        .overflow(logical_lost_o[1]), .underflow(logical_lost_o[0]));
    lpm_clshift #(.LPM_WIDTH(8), .LPM_WIDTHDIST(3), .LPM_SHIFTTYPE("ARITHMETIC")) arithmetic (
        .data(a_i[7:0]), .distance(distance_i), .direction(direction_i), .result(arithmetic_o),
        .overflow(arithmetic_lost_o[1]), .underflow(arithmetic_lost_o[0]));
    lpm_clshift #(.LPM_WIDTH(7), .LPM_WIDTHDIST(3), .LPM_SHIFTTYPE("ROTATE")) rotate (
        .data(a_i[6:0]), .distance(distance_i), .direction(direction_i), .result(rotate_o));
    lpm_clshift #(.LPM_WIDTH(8), .LPM_WIDTHDIST(3), .LPM_PIPELINE(1)) later (
        .clock(clock_i), .clken(enable_i), .aclr(aclr_i), .data(a_i[7:0]),
        .distance(distance_i), .direction(direction_i), .result(later_o));

    wire [7:0] bus;
    assign bus = drive_i ? a_i[15:8] : 8'bz;
    lpm_bustri #(.LPM_WIDTH(8)) buffers (
        .data(a_i[7:0]), .enabledt(!drive_i), .enabletr(1'b1), .result(from_bus_o),
        .tridata(bus));
    assign bus_o = bus;
endmodule

`default_nettype wire
