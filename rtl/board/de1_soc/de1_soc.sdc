# de1_soc.sdc - clocks and the pins' timing

create_clock -name CLOCK_50 -period 20.0 [get_ports CLOCK_50]
derive_pll_clocks
derive_clock_uncertainty

# ---- VGA: the ADV7123 samples at the rising edge of VGA_CLK, which is the inverted pixel clock.
# Its datasheet: set-up 0.2 ns, hold 1.5 ns.
set pixel_clock [get_pins -compatibility_mode {*clock_reset*pll*divclk}]
create_generated_clock -name VGA_CLK -source $pixel_clock -invert [get_ports VGA_CLK]
set vga [get_ports {VGA_R[*] VGA_G[*] VGA_B[*] VGA_HS VGA_VS VGA_BLANK_N}]
set_output_delay -clock VGA_CLK -max 0.2 $vga
set_output_delay -clock VGA_CLK -min -1.5 $vga

# ---- SDRAM: samples at the rising edge of DRAM_CLK, the inverted clock of the fabric.  The fabric
# samples read data at its next rising edge.  Datasheet of the -7 part: set-up 1.5 ns, hold 0.8 ns;
# access time 5.4 ns, output hold 2.7 ns.
create_generated_clock -name DRAM_CLK -source $pixel_clock -invert [get_ports DRAM_CLK]
set dram [get_ports {DRAM_CS_N DRAM_RAS_N DRAM_CAS_N DRAM_WE_N DRAM_BA[*] DRAM_ADDR[*] \
    DRAM_LDQM DRAM_UDQM DRAM_DQ[*]}]
set_output_delay -clock DRAM_CLK -max 1.5 $dram
set_output_delay -clock DRAM_CLK -min -0.8 $dram
set_input_delay -clock DRAM_CLK -max 5.4 [get_ports DRAM_DQ[*]]
set_input_delay -clock DRAM_CLK -min 2.7 [get_ports DRAM_DQ[*]]

# ---- Audio: a domain of its own, constrained for 48 kHz.  Pairs cross by FIFOs with pointers in
# Gray code (common/dual_clock_fifo.v).  A pointer changes one bit at a time, and rests for longer
# than any routing delay.
set xck [get_pins -compatibility_mode {*audio_clock*pll*divclk}]
create_generated_clock -name AUDIO -source $xck -divide_by 2 [get_registers {*audio_clock*clk_q}]
set_clock_groups -asynchronous -group [get_clocks {*clock_reset*pll*divclk VGA_CLK DRAM_CLK}] \
    -group [get_clocks {*audio_clock*pll*divclk AUDIO}]

# ---- The video decoder: its data move on the falling edge of its clock, by the ADV7180's datasheet
# from 2.4 ns before it to 3.6 ns after it.  Words cross by the same kind of FIFO.
create_clock -name TD_CLK27 -period 37.037 [get_ports TD_CLK27]
set_input_delay -clock TD_CLK27 -clock_fall -max 3.6 [get_ports TD_DATA[*]]
set_input_delay -clock TD_CLK27 -clock_fall -min -2.4 [get_ports TD_DATA[*]]
set_clock_groups -asynchronous -group [get_clocks TD_CLK27]

# ---- Pins without a timing relation to the clock, and why.
# Keys, switches and headers: asynchronous, through two flip-flops.
set_false_path -from [get_ports {KEY[*] SW[*] GPIO_0[*] GPIO_1[*]}]
# Lamps and digits are seen by eye; the headers have no clock.
set_false_path -to [get_ports {LEDR[*] HEX0[*] HEX1[*] HEX2[*] HEX3[*] HEX4[*] HEX5[*]}]
set_false_path -to [get_ports {GPIO_0[*] GPIO_1[*]}]
# The codec: data moves on BCLK's falling edge and is taken on its rising edge, 160 ns or more later,
# at both ends.  I2C is slower still, and its answers pass two flip-flops.
set_false_path -to [get_ports {AUD_* FPGA_I2C_SCLK FPGA_I2C_SDAT}]
set_false_path -from [get_ports {AUD_ADCDAT FPGA_I2C_SDAT}]
# Infrared, 115 kHz, in by two flip-flops.
set_false_path -to [get_ports IRDA_TXD]
set_false_path -from [get_ports IRDA_RXD]
# PS/2: 17 kHz at most, in by two flip-flops.  ADC: a bit lasts two clocks and is sampled once
# stable.
set_false_path -to [get_ports {PS2_* ADC_CS_N ADC_SCLK ADC_DIN}]
set_false_path -from [get_ports {PS2_* ADC_DOUT}]
# Constant.
set_false_path -to [get_ports {VGA_SYNC_N DRAM_CKE TD_RESET_N}]
# The reset is released through two flip-flops of its own.
set_false_path -to [get_registers {*reset_sync|release_q[*]}]
