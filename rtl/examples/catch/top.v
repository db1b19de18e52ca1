// top.v - the pins of the catch game's system: monitor, SDRAM, keyboard, loudspeaker, LEDs, a digit
module top (
    input  wire        CLOCK_50,
    output wire [9:0]  LEDR,
    output wire [6:0]  HEX0,

    output wire [12:0] DRAM_ADDR,
    output wire [1:0]  DRAM_BA,
    output wire        DRAM_CAS_N,
    output wire        DRAM_CKE,
    output wire        DRAM_CLK,
    output wire        DRAM_CS_N,
    inout  wire [15:0] DRAM_DQ,
    output wire        DRAM_LDQM,
    output wire        DRAM_RAS_N,
    output wire        DRAM_UDQM,
    output wire        DRAM_WE_N,

    output wire        VGA_CLK,
    output wire        VGA_HS,
    output wire        VGA_VS,
    output wire        VGA_BLANK_N,
    output wire        VGA_SYNC_N,
    output wire [7:0]  VGA_R,
    output wire [7:0]  VGA_G,
    output wire [7:0]  VGA_B,

    inout  wire        PS2_CLK,
    inout  wire        PS2_DAT,

    output wire        FPGA_I2C_SCLK,
    inout  wire        FPGA_I2C_SDAT,
    output wire        AUD_XCK,
    inout  wire        AUD_BCLK,
    output wire        AUD_DACDAT,
    inout  wire        AUD_DACLRCK
);
    wire [6:0] segments;
    assign HEX0 = ~segments;

    catch_system system (
        .clk_clk(CLOCK_50),
        .reset_reset_n(1'b1),
        .lives_export(LEDR),
        .score_export(segments),
        .sdram_clk_clk(DRAM_CLK),
        .sdram_addr(DRAM_ADDR),
        .sdram_ba(DRAM_BA),
        .sdram_cas_n(DRAM_CAS_N),
        .sdram_cke(DRAM_CKE),
        .sdram_cs_n(DRAM_CS_N),
        .sdram_dq(DRAM_DQ),
        .sdram_dqm({DRAM_UDQM, DRAM_LDQM}),
        .sdram_ras_n(DRAM_RAS_N),
        .sdram_we_n(DRAM_WE_N),
        .vga_CLK(VGA_CLK),
        .vga_HS(VGA_HS),
        .vga_VS(VGA_VS),
        .vga_BLANK(VGA_BLANK_N),
        .vga_SYNC(VGA_SYNC_N),
        .vga_R(VGA_R),
        .vga_G(VGA_G),
        .vga_B(VGA_B),
        .ps2_CLK(PS2_CLK),
        .ps2_DAT(PS2_DAT),
        .i2c_SCLK(FPGA_I2C_SCLK),
        .i2c_SDAT(FPGA_I2C_SDAT),
        .audio_clk_clk(AUD_XCK),
        .audio_BCLK(AUD_BCLK),
        .audio_DACDAT(AUD_DACDAT),
        .audio_DACLRCK(AUD_DACLRCK)
    );
endmodule
