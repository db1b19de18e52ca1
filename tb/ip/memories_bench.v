// memories_bench.v - the memories and FIFOs of the LPM library, at common inputs

`default_nettype none

module memories_bench (
    input  wire       wrclock_i, rdclock_i, aclr_i, enable_i,
    input  wire       wrreq_i, rdreq_i,
    input  wire [3:0] wraddress_i, rdaddress_i,
    input  wire [7:0] data_i,

    output wire [7:0] ram_o, late_ram_o,       // without and with output register
    output wire [7:0] q_o, ahead_o,
    output wire [2:0] used_o,
    output wire       full_o, empty_o, ahead_empty_o,
    output wire [7:0] dc_o,
    output wire       dc_full_o, dc_empty_o
);
    lpm_ram_dp #(
        .LPM_WIDTH(8), .LPM_WIDTHAD(4), .LPM_OUTDATA("UNREGISTERED")
    ) ram (
        .wrclock(wrclock_i), .wrclken(enable_i), .wren(wrreq_i), .wraddress(wraddress_i),
        .data(data_i), .rdclock(rdclock_i), .rdclken(1'b1), .rden(rdreq_i),
        .rdaddress(rdaddress_i), .q(ram_o));
    lpm_ram_dp late_ram (
        .wrclock(wrclock_i), .wrclken(1'b1), .wren(wrreq_i), .wraddress(wraddress_i),
        .data(data_i), .rdclock(rdclock_i), .rdclken(enable_i), .rden(1'b1),
        .rdaddress(rdaddress_i), .q(late_ram_o));
    defparam
        late_ram.lpm_width = 8,
        late_ram.lpm_widthad = 4,
        late_ram.lpm_indata = "REGISTERED",
        late_ram.lpm_outdata = "REGISTERED";

    lpm_fifo #(.LPM_WIDTH(8), .LPM_WIDTHU(3), .LPM_NUMWORDS(8)) fifo (
        .clock(wrclock_i), .aclr(aclr_i), .wrreq(wrreq_i), .rdreq(rdreq_i), .data(data_i),
        .q(q_o), .usedw(used_o), .full(full_o), .empty(empty_o));
    lpm_fifo #(
        .LPM_WIDTH(8), .LPM_WIDTHU(3), .LPM_NUMWORDS(8), .LPM_SHOWAHEAD("ON")
    ) ahead (
        .clock(wrclock_i), .aclr(aclr_i), .wrreq(wrreq_i), .rdreq(rdreq_i && !ahead_empty_o),
        .data(data_i), .q(ahead_o), .empty(ahead_empty_o));
    lpm_fifo_dc #(.LPM_WIDTH(8), .LPM_WIDTHU(3), .LPM_NUMWORDS(8)) dc (
        .aclr(aclr_i), .wrclock(wrclock_i), .wrreq(wrreq_i), .data(data_i), .wrfull(dc_full_o),
        .rdclock(rdclock_i), .rdreq(rdreq_i), .q(dc_o), .rdempty(dc_empty_o));
endmodule

`default_nettype wire
