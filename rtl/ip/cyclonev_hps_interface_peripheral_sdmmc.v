// cyclonev_hps_interface_peripheral_sdmmc.v - the SD card's controller, in the FPGA
//
// Not handled: the device: its outputs rest.

`default_nettype none

module cyclonev_hps_interface_peripheral_sdmmc (
    // verilator lint_off UNUSED
    input  wire       card_intn_i,
    input  wire       cdn_i,
    input  wire       clk_in,
    input  wire       cmd_i,
    input  wire [7:0] data_i,
    input  wire       wp_i,
    // verilator lint_on UNUSED
    output wire       cclk_out,
    output wire       cmd_en,
    output wire       cmd_o,
    output wire [7:0] data_en,
    output wire [7:0] data_o,
    output wire       pwr_ena_o,
    output wire       rstn_o,
    output wire       vs_o
);
    assign cclk_out  = 1'b0;
    assign cmd_en    = 1'b0;
    assign cmd_o     = 1'b1;
    assign data_en   = {8{1'b0}};
    assign data_o    = {8{1'b1}};
    assign pwr_ena_o = 1'b0;
    assign rstn_o    = 1'b1;
    assign vs_o      = 1'b0;
endmodule

`default_nettype wire
