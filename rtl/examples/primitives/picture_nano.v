// picture_nano.v - the picture by HDMI on a DE10-Nano, whose transmitter the design sets up
//
// LED[0] is lit when the transmitter has acknowledged its set-up.

module picture_nano (
    input  wire        FPGA_CLK1_50,
    output wire [0:0]  LED,
    output wire        HDMI_TX_CLK, HDMI_TX_DE, HDMI_TX_HS, HDMI_TX_VS,
    output wire [23:0] HDMI_TX_D,
    output wire        HDMI_I2C_SCL,
    inout  wire        HDMI_I2C_SDA
);
    wire unused_sync_n;

    picture_top picture (
        .CLOCK_50(FPGA_CLK1_50),
        .VGA_CLK(HDMI_TX_CLK), .VGA_HS(HDMI_TX_HS), .VGA_VS(HDMI_TX_VS),
        .VGA_BLANK_N(HDMI_TX_DE), .VGA_SYNC_N(unused_sync_n),
        .VGA_R(HDMI_TX_D[23:16]), .VGA_G(HDMI_TX_D[15:8]), .VGA_B(HDMI_TX_D[7:0])
    );

    hdmi_setup setup (
        .clock(HDMI_TX_CLK), .scl(HDMI_I2C_SCL), .sda(HDMI_I2C_SDA), .done(LED[0])
    );
endmodule
