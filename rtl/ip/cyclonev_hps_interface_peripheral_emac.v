// cyclonev_hps_interface_peripheral_emac.v - an Ethernet controller of the processor's, in the FPGA
//
// Not handled: the device: its outputs rest.

`default_nettype none

module cyclonev_hps_interface_peripheral_emac (
    // verilator lint_off UNUSED
    input  wire       clk_rx_i,
    input  wire       clk_tx_i,
    input  wire       gmii_mdi_i,
    input  wire       phy_col_i,
    input  wire       phy_crs_i,
    input  wire [7:0] phy_rxd_i,
    input  wire       phy_rxdv_i,
    input  wire       phy_rxer_i,
    input  wire       ptp_aux_ts_trig_i,
    // verilator lint_on UNUSED
    output wire       gmii_mdc_o,
    output wire       gmii_mdo_o,
    output wire       gmii_mdo_o_e,
    output wire       phy_txclk_o,
    output wire [7:0] phy_txd_o,
    output wire       phy_txen_o,
    output wire       phy_txer_o,
    output wire       ptp_pps_o,
    output wire       rst_clk_rx_n_o,
    output wire       rst_clk_tx_n_o
);
    assign gmii_mdc_o     = 1'b0;
    assign gmii_mdo_o     = 1'b0;
    assign gmii_mdo_o_e   = 1'b0;
    assign phy_txclk_o    = 1'b0;
    assign phy_txd_o      = {8{1'b0}};
    assign phy_txen_o     = 1'b0;
    assign phy_txer_o     = 1'b0;
    assign ptp_pps_o      = 1'b0;
    assign rst_clk_rx_n_o = 1'b1;
    assign rst_clk_tx_n_o = 1'b1;
endmodule

`default_nettype wire
