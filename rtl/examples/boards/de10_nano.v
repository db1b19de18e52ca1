// de10_nano.v - the bands on a DE10-Nano, by its HDMI transmitter
//
// LED[6:0] count KEY0; LED[7] is lit when the transmitter has acknowledged its set-up. KEY1 sounds.

module de10_nano (
    input         FPGA_CLK1_50,
    input  [1:0]  KEY,
    input  [3:0]  SW,
    output [7:0]  LED,
    output        HDMI_TX_CLK,
    output        HDMI_TX_DE,
    output        HDMI_TX_HS,
    output        HDMI_TX_VS,
    output [23:0] HDMI_TX_D,
    output        HDMI_SCLK,
    output        HDMI_LRCLK,
    output        HDMI_I2S,
    output        HDMI_I2C_SCL,
    inout         HDMI_I2C_SDA
);
    reg clock = 0;
    always @(posedge FPGA_CLK1_50) clock <= ~clock;

    wire [7:0] count;
    wire [3:0] red, green, blue;
    wire       done;
    bands picture (.clock(clock), .key_n(KEY[0]), .negative(SW[0]), .hs(HDMI_TX_HS),
                   .vs(HDMI_TX_VS), .visible(HDMI_TX_DE), .red(red), .green(green), .blue(blue),
                   .count(count));
    hdmi_setup setup (.clock(clock), .scl(HDMI_I2C_SCL), .sda(HDMI_I2C_SDA), .done(done));

    i2s_tone tone (.clock(clock), .on(!KEY[1]), .sclk(HDMI_SCLK), .lrclk(HDMI_LRCLK),
                   .sdata(HDMI_I2S));

    assign LED = {done, count[6:0]};
    assign HDMI_TX_CLK = ~clock;
    assign HDMI_TX_D = {red, red, green, green, blue, blue};
endmodule
