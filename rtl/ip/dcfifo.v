// dcfifo.v - Intel's FIFO from one clock to another: dcfifo_mixed_widths with equal widths

`default_nettype none

module dcfifo #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_widthu = 1, LPM_WIDTHU = lpm_widthu,
    parameter lpm_numwords = 4, LPM_NUMWORDS = lpm_numwords,
    parameter lpm_showahead = "OFF", LPM_SHOWAHEAD = lpm_showahead,
    parameter rdsync_delaypipe = 4, RDSYNC_DELAYPIPE = rdsync_delaypipe,
    parameter wrsync_delaypipe = 4, WRSYNC_DELAYPIPE = wrsync_delaypipe,
    // Without meaning here.
    parameter add_ram_output_register = "OFF", ADD_RAM_OUTPUT_REGISTER = add_ram_output_register,
    parameter clocks_are_synchronized = "FALSE",
    parameter CLOCKS_ARE_SYNCHRONIZED = clocks_are_synchronized,
    parameter add_usedw_msb_bit = "OFF", ADD_USEDW_MSB_BIT = add_usedw_msb_bit,
    parameter delay_rdusedw = 1, DELAY_RDUSEDW = delay_rdusedw,
    parameter delay_wrusedw = 1, DELAY_WRUSEDW = delay_wrusedw,
    parameter enable_ecc = "FALSE", ENABLE_ECC = enable_ecc,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "dcfifo", LPM_TYPE = lpm_type,
    parameter maximize_speed = 5, MAXIMIZE_SPEED = maximize_speed,
    parameter optimize_for_speed = 5, OPTIMIZE_FOR_SPEED = optimize_for_speed,
    parameter overflow_checking = "ON", OVERFLOW_CHECKING = overflow_checking,
    parameter ram_block_type = "AUTO", RAM_BLOCK_TYPE = ram_block_type,
    parameter read_aclr_synch = "OFF", READ_ACLR_SYNCH = read_aclr_synch,
    parameter underflow_checking = "ON", UNDERFLOW_CHECKING = underflow_checking,
    parameter use_eab = "ON", USE_EAB = use_eab,
    parameter write_aclr_synch = "OFF", WRITE_ACLR_SYNCH = write_aclr_synch
) (
    input  wire                    aclr,

    input  wire                    wrclk, wrreq,
    input  wire [LPM_WIDTH-1:0]    data,
    output wire                    wrfull, wrempty,
    output wire [LPM_WIDTHU-1:0]   wrusedw,

    input  wire                    rdclk, rdreq,
    output wire [LPM_WIDTH-1:0]    q,
    output wire                    rdfull, rdempty,
    output wire [LPM_WIDTHU-1:0]   rdusedw,

    output wire [1:0]              eccstatus
);
    dcfifo_mixed_widths #(
        .LPM_WIDTH(LPM_WIDTH), .LPM_WIDTHU(LPM_WIDTHU), .LPM_WIDTH_R(LPM_WIDTH),
        .LPM_WIDTHU_R(LPM_WIDTHU), .LPM_NUMWORDS(LPM_NUMWORDS), .LPM_SHOWAHEAD(LPM_SHOWAHEAD),
        .RDSYNC_DELAYPIPE(RDSYNC_DELAYPIPE), .WRSYNC_DELAYPIPE(WRSYNC_DELAYPIPE)
    ) fifo (
        .aclr(aclr), .wrclk(wrclk), .wrreq(wrreq), .data(data), .wrfull(wrfull),
        .wrempty(wrempty), .wrusedw(wrusedw), .rdclk(rdclk), .rdreq(rdreq), .q(q),
        .rdfull(rdfull), .rdempty(rdempty), .rdusedw(rdusedw), .eccstatus(eccstatus)
    );
endmodule

`default_nettype wire
