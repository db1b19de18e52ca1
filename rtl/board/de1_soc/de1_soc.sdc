# de1_soc.sdc - clocks and the pins' timing

create_clock -name CLOCK_50 -period 20.0 [get_ports CLOCK_50]
derive_pll_clocks
derive_clock_uncertainty

# ---- VGA: the ADV7123 samples at the rising edge of VGA_CLK, which is the pixel clock upside down.
# Its datasheet: set-up 0.2 ns, hold 1.5 ns.
set pixel_clock [get_pins -compatibility_mode {*pll*|*outclk*divclk}]
create_generated_clock -name VGA_CLK -source $pixel_clock -invert [get_ports VGA_CLK]
set vga [get_ports {VGA_R[*] VGA_G[*] VGA_B[*] VGA_HS VGA_VS VGA_BLANK_N}]
set_output_delay -clock VGA_CLK -max 0.2 $vga
set_output_delay -clock VGA_CLK -min -1.5 $vga

# ---- What has no timing against the clock, and why.
# Hands and wires: two flip-flops bring them in.
set_false_path -from [get_ports {KEY[*] SW[*] GPIO_0[*] GPIO_1[*]}]
# Eyes, and headers without a clock.
set_false_path -to [get_ports {LEDR[*] HEX0[*] HEX1[*] HEX2[*] HEX3[*] HEX4[*] HEX5[*]}]
set_false_path -to [get_ports {GPIO_0[*] GPIO_1[*]}]
# The codec: 1 / 16 and less of the clock's rate; data moves on BCLK's falling edge and is taken on
# its rising edge, hundreds of nanoseconds later.  Its answers pass two flip-flops.
set_false_path -to [get_ports {AUD_* FPGA_I2C_SCLK FPGA_I2C_SDAT}]
set_false_path -from [get_ports {AUD_ADCDAT FPGA_I2C_SDAT}]
# PS/2, 17 kHz at most, in by two flip-flops; the ADC, a bit in two clocks and taken where it stands.
set_false_path -to [get_ports {PS2_* ADC_CS_N ADC_SCLK ADC_DIN}]
set_false_path -from [get_ports {PS2_* ADC_DOUT}]
# Constant.
set_false_path -to [get_ports VGA_SYNC_N]
# The reset is released through two flip-flops of its own.
set_false_path -to [get_registers {*reset_sync|release_q[*]}]
