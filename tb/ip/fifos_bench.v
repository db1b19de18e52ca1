// fifos_bench.v - FIFOs at common inputs

`default_nettype none

module fifos_bench (
    input  wire        clock_i, rdclk_i,    // clock_i is wrclk, too
    input  wire        aclr_i, sclr_i,
    input  wire        wrreq_i, rdreq_i,
    input  wire [31:0] data_i,

    // Of one clock: normal, show-ahead with output register, show-ahead with logic cells.
    output wire [7:0]  normal_o, ahead_o, cells_o,
    output wire [2:0]  normal_used_o,
    output wire [2:0]  full_o, empty_o, almost_full_o, almost_empty_o,

    // Of two clocks: 8 bits, show-ahead 8 bits, 8 to 32 bits, 32 to 8 bits.
    output wire [7:0]  two_o, two_ahead_o,
    output wire [31:0] widen_o,
    output wire [7:0]  narrow_o,
    output wire [3:0]  wrfull_o, wrempty_o, rdfull_o, rdempty_o,
    output wire [3:0]  two_wrused_o, two_rdused_o,
    output wire [3:0]  widen_wrused_o, narrow_rdused_o,
    output wire [1:0]  widen_rdused_o, narrow_wrused_o
);
    scfifo normal (
        .clock(clock_i), .aclr(aclr_i), .sclr(sclr_i), .data(data_i[7:0]), .wrreq(wrreq_i),
        .rdreq(rdreq_i), .q(normal_o), .usedw(normal_used_o), .full(full_o[0]),
        .empty(empty_o[0]), .almost_full(almost_full_o[0]), .almost_empty(almost_empty_o[0]),
        .eccstatus());
    defparam
        normal.add_ram_output_register = "OFF",
        normal.almost_empty_value = 2,
        normal.almost_full_value = 6,
        normal.intended_device_family = "Cyclone V",
        normal.lpm_hint = "RAM_BLOCK_TYPE=M10K",
        normal.lpm_numwords = 8,
        normal.lpm_showahead = "OFF",
        normal.lpm_type = "scfifo",
        normal.lpm_width = 8,
        normal.lpm_widthu = 3,
        normal.overflow_checking = "ON",
        normal.underflow_checking = "ON",
        normal.use_eab = "ON";

    scfifo #(
        .LPM_WIDTH(8), .LPM_WIDTHU(3), .LPM_NUMWORDS(5), .LPM_SHOWAHEAD("ON"),
        .ADD_RAM_OUTPUT_REGISTER("ON"), .ALLOW_RWCYCLE_WHEN_FULL("ON")
    ) ahead (
        .clock(clock_i), .aclr(aclr_i), .sclr(sclr_i), .data(data_i[7:0]), .wrreq(wrreq_i),
        .rdreq(rdreq_i), .q(ahead_o), .full(full_o[1]), .empty(empty_o[1]),
        .almost_full(almost_full_o[1]), .almost_empty(almost_empty_o[1]));

    scfifo #(
        .LPM_WIDTH(8), .LPM_WIDTHU(2), .LPM_NUMWORDS(4), .LPM_SHOWAHEAD("ON"), .USE_EAB("OFF")
    ) cells (
        .clock(clock_i), .aclr(aclr_i), .sclr(sclr_i), .data(data_i[7:0]), .wrreq(wrreq_i),
        .rdreq(rdreq_i), .q(cells_o), .full(full_o[2]), .empty(empty_o[2]),
        .almost_full(almost_full_o[2]), .almost_empty(almost_empty_o[2]));

    dcfifo two (
        .wrclk(clock_i), .rdclk(rdclk_i), .aclr(aclr_i), .data(data_i[7:0]), .wrreq(wrreq_i),
        .rdreq(rdreq_i), .q(two_o), .wrfull(wrfull_o[0]), .wrempty(wrempty_o[0]),
        .rdfull(rdfull_o[0]), .rdempty(rdempty_o[0]), .wrusedw(two_wrused_o),
        .rdusedw(two_rdused_o), .eccstatus());
    defparam
        two.add_usedw_msb_bit = "ON",
        two.intended_device_family = "Cyclone V",
        two.lpm_numwords = 8,
        two.lpm_showahead = "OFF",
        two.lpm_type = "dcfifo",
        two.lpm_width = 8,
        two.lpm_widthu = 4,
        two.overflow_checking = "ON",
        two.rdsync_delaypipe = 4,
        two.read_aclr_synch = "OFF",
        two.underflow_checking = "ON",
        two.use_eab = "ON",
        two.write_aclr_synch = "OFF",
        two.wrsync_delaypipe = 5;

    dcfifo #(
        .LPM_NUMWORDS(8), .LPM_WIDTH(8), .LPM_WIDTHU(3), .LPM_SHOWAHEAD("ON"),
        .RDSYNC_DELAYPIPE(5)
    ) two_ahead (
        .wrclk(clock_i), .rdclk(rdclk_i), .aclr(aclr_i), .data(data_i[7:0]), .wrreq(wrreq_i),
        .rdreq(rdreq_i), .q(two_ahead_o), .wrfull(wrfull_o[1]), .wrempty(wrempty_o[1]),
        .rdfull(rdfull_o[1]), .rdempty(rdempty_o[1]));

    dcfifo_mixed_widths widen (
        .wrclk(clock_i), .rdclk(rdclk_i), .aclr(aclr_i), .data(data_i[7:0]), .wrreq(wrreq_i),
        .rdreq(rdreq_i), .q(widen_o), .wrfull(wrfull_o[2]), .wrempty(wrempty_o[2]),
        .rdfull(rdfull_o[2]), .rdempty(rdempty_o[2]), .wrusedw(widen_wrused_o),
        .rdusedw(widen_rdused_o));
    defparam
        widen.lpm_numwords = 8,
        widen.lpm_showahead = "OFF",
        widen.lpm_type = "dcfifo_mixed_widths",
        widen.add_usedw_msb_bit = "ON",
        widen.lpm_width = 8,
        widen.lpm_widthu = 4,
        widen.lpm_widthu_r = 2,
        widen.lpm_width_r = 32;

    dcfifo_mixed_widths #(
        .LPM_NUMWORDS(2), .LPM_WIDTH(32), .LPM_WIDTHU(2), .LPM_WIDTH_R(8), .LPM_WIDTHU_R(4),
        .LPM_SHOWAHEAD("ON"), .ADD_USEDW_MSB_BIT("ON")
    ) narrow (
        .wrclk(clock_i), .rdclk(rdclk_i), .aclr(aclr_i), .data(data_i), .wrreq(wrreq_i),
        .rdreq(rdreq_i), .q(narrow_o), .wrfull(wrfull_o[3]), .wrempty(wrempty_o[3]),
        .rdfull(rdfull_o[3]), .rdempty(rdempty_o[3]), .wrusedw(narrow_wrused_o),
        .rdusedw(narrow_rdused_o));
endmodule

`default_nettype wire
