// lpm_fifo_dc.v - a FIFO from one clock to another, by dcfifo

`default_nettype none

module lpm_fifo_dc #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_widthu = 1, LPM_WIDTHU = lpm_widthu,
    parameter lpm_numwords = 4, LPM_NUMWORDS = lpm_numwords,
    parameter lpm_showahead = "OFF", LPM_SHOWAHEAD = lpm_showahead,
    parameter rdsync_delaypipe = 3, RDSYNC_DELAYPIPE = rdsync_delaypipe,
    parameter wrsync_delaypipe = 3, WRSYNC_DELAYPIPE = wrsync_delaypipe,
    // Without meaning here.
    parameter underflow_checking = "ON", UNDERFLOW_CHECKING = underflow_checking,
    parameter overflow_checking = "ON", OVERFLOW_CHECKING = overflow_checking,
    parameter delay_rdusedw = 1, DELAY_RDUSEDW = delay_rdusedw,
    parameter delay_wrusedw = 1, DELAY_WRUSEDW = delay_wrusedw,
    parameter use_eab = "ON", USE_EAB = use_eab,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_fifo_dc", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                  aclr,
    input  wire                  wrclock, wrreq,
    input  wire [LPM_WIDTH-1:0]  data,
    output wire                  wrfull, wrempty,
    output wire [LPM_WIDTHU-1:0] wrusedw,
    input  wire                  rdclock, rdreq,
    output wire [LPM_WIDTH-1:0]  q,
    output wire                  rdfull, rdempty,
    output wire [LPM_WIDTHU-1:0] rdusedw
);
    dcfifo #(
        .LPM_WIDTH(LPM_WIDTH), .LPM_WIDTHU(LPM_WIDTHU), .LPM_NUMWORDS(LPM_NUMWORDS),
        .LPM_SHOWAHEAD(LPM_SHOWAHEAD), .RDSYNC_DELAYPIPE(RDSYNC_DELAYPIPE),
        .WRSYNC_DELAYPIPE(WRSYNC_DELAYPIPE)
    ) fifo (
        .aclr(aclr), .wrclk(wrclock), .wrreq(wrreq), .data(data), .wrfull(wrfull),
        .wrempty(wrempty), .wrusedw(wrusedw), .rdclk(rdclock), .rdreq(rdreq), .q(q),
        .rdfull(rdfull), .rdempty(rdempty), .rdusedw(rdusedw), .eccstatus());
endmodule

`default_nettype wire
