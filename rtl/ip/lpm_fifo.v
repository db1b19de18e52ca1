// lpm_fifo.v - a FIFO of one clock, by scfifo

`default_nettype none

module lpm_fifo #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_widthu = 1, LPM_WIDTHU = lpm_widthu,
    parameter lpm_numwords = 2, LPM_NUMWORDS = lpm_numwords,
    parameter lpm_showahead = "OFF", LPM_SHOWAHEAD = lpm_showahead,
    // Without meaning here.
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_fifo", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                  clock, aclr, sclr,
    input  wire                  wrreq, rdreq,
    input  wire [LPM_WIDTH-1:0]  data,
    output wire [LPM_WIDTH-1:0]  q,
    output wire [LPM_WIDTHU-1:0] usedw,
    output wire                  full, empty
);
    scfifo #(
        .LPM_WIDTH(LPM_WIDTH), .LPM_WIDTHU(LPM_WIDTHU), .LPM_NUMWORDS(LPM_NUMWORDS),
        .LPM_SHOWAHEAD(LPM_SHOWAHEAD)
    ) fifo (
        .clock(clock), .aclr(aclr), .sclr(sclr), .wrreq(wrreq), .rdreq(rdreq), .data(data),
        .q(q), .usedw(usedw), .full(full), .empty(empty), .almost_full(), .almost_empty(),
        .eccstatus());
endmodule

`default_nettype wire
