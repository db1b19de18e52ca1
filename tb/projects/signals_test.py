"""signals_test.py DE1SIM FOLDER [CASE...] - clocks, resets, general purpose signals, interrupts

What is between processor and FPGA beside the bridges, by the primitives and by Platform Designer.
"""
import re

from case import run
from systems import BASE, CLOCKS, LW, SystemCase, clocked, qsys

GPO = "#define GPO R32(0xFF706010)\n#define GPI R32(0xFF706014)\n"
# The processor's gpo on the lamps; {body} may use clocks[2:0], the user clocks.
TOP = """module top(input CLOCK_50, input [9:0] SW, input [3:0] KEY, output [9:0] LEDR{ports});
wire [31:0] gpo; wire [2:0] clocks; wire reset_n, cold_n;
cyclonev_hps_interface_mpu_general_purpose gp(.gp_in({gpi}), .gp_out(gpo));
cyclonev_hps_interface_clocks_resets signals(.h2f_rst_n(reset_n), .h2f_cold_rst_n(cold_n){wires});
{body}
endmodule
"""
USER_CLOCKS = ", .h2f_user0_clk(clocks[0]), .h2f_user1_clk(clocks[1]), .h2f_user2_clk(clocks[2])"


class SignalCase(SystemCase):
    def top(self, body="assign LEDR = gpo;", gpi="{22'd0, SW}", wires="", ports=""):
        self.write(top_v=TOP.format(body=body, gpi=gpi, wires=wires, ports=ports),
                   top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                           "set_global_assignment -name TOP_LEVEL_ENTITY top\n"
                           "set_global_assignment -name VERILOG_FILE top.v\n")


class GeneralPurpose(SignalCase):
    PROGRAM = GPO + "for (;;) GPO = GPI ^ 0x3F0 ^ (GPO & 0);"

    def test_signals_go_both_ways(self):
        self.top()
        self.program(self.PROGRAM)
        self.shows(0x3FF ^ 0x030, ["hold: {switch: [0, 1, 2, 3, 4, 5]}"])

    def test_an_answer_is_there_at_the_next_instruction(self):
        self.top(gpi="~gpo")
        self.program(GPO + "uint32_t n, good = 0;\n"
                     "for (n = 0; n < 1000; n++) { GPO = n * 77; good += GPI == ~(n * 77); }\n"
                     "GPO = good;")
        self.shows(1000)

    def test_platform_designer_exports_them(self):
        processor = {**BASE[1][2], "GP_Enable": "true"}
        self.write(sys_qsys=qsys([BASE[0], ("hps_0", "altera_hps", processor)], CLOCKS,
                                 [("gp", "hps_0.h2f_gp")]),
                   top_v="module top(input CLOCK_50, input [9:0] SW, output [9:0] LEDR);\n"
                         "wire [31:0] gpo; assign LEDR = gpo;\n"
                         "sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1),\n"
                         "    .gp_gp_in({22'd0, SW}), .gp_gp_out(gpo));\nendmodule\n",
                   top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                           "set_global_assignment -name VERILOG_FILE top.v\n"
                           "set_global_assignment -name QSYS_FILE sys.qsys\n")
        self.program(self.PROGRAM)
        self.shows(0x3F0 ^ 3, ["hold: {switch: [0, 1]}"])


    def test_platform_designer_has_a_cold_reset_and_the_processors_events(self):
        processor = {**BASE[1][2], "S2FCLK_COLDRST_Enable": "true"}
        self.write(sys_qsys=qsys([BASE[0], ("hps_0", "altera_hps", processor)], CLOCKS,
                                 [("cold", "hps_0.h2f_cold_reset"),
                                  ("events", "hps_0.h2f_mpu_events")]),
                   top_v="module top(input CLOCK_50, output [9:0] LEDR);\n"
                         "wire cold_n, o; wire [1:0] wfe, wfi;\n"
                         "assign LEDR = {4'd5, cold_n, wfi, wfe, o};\n"
                         "sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1),\n"
                         "    .cold_reset_n(cold_n), .events_eventi(1'b0),\n"
                         "    .events_evento(o), .events_standbywfe(wfe),\n"
                         "    .events_standbywfi(wfi));\nendmodule\n",
                   top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                           "set_global_assignment -name VERILOG_FILE top.v\n"
                           "set_global_assignment -name QSYS_FILE sys.qsys\n")
        self.program("")
        self.shows(0x160)


class UserClocks(SignalCase):
    COUNTERS = """reg [13:0] all = 0; reg [13:0] c0 = 0, c1 = 0, c2 = 0;
wire counts = all < 5000; assign LEDR = {7'd0, c2 - 14'd13328 < 8,
    c1 - 14'd194 < 4, c0 - 14'd9996 < 8};
always @(posedge CLOCK_50) if (counts) all <= all + 1;
always @(posedge clocks[0]) if (counts) c0 <= c0 + 1;
always @(posedge clocks[1]) if (counts) c1 <= c1 + 1;
always @(posedge clocks[2]) if (counts) c2 <= c2 + 1;"""

    def pll_clocks(self):
        facts = list(self.folder.rglob("de1sim_facts.h"))
        self.assertEqual(len(facts), 1)
        return int(re.search(r"PLL_CLOCK_COUNT = (\d+)", facts[0].read_text()).group(1))

    def test_they_are_those_of_the_preloader(self):
        self.top(self.COUNTERS, wires=USER_CLOCKS)
        self.program("")
        self.shows(7, ["delay: 1ms"])
        self.assertEqual(self.pll_clocks(), 3)

    def test_one_that_nobody_connects_is_none_of_the_simulation(self):
        self.top("assign LEDR = {9'd0, clocks[1]};", wires=", .h2f_user1_clk(clocks[1]), "
                 ".h2f_user2_clk()")
        self.assertEqual(self.de1sim("build", ".").returncode, 0)
        self.assertEqual(self.pll_clocks(), 1)
        said = self.de1sim("check", ".").stdout
        self.assertIn("  h2f_user1_clk: 1.953125 MHz, phase 0.000 ns\n", said)
        self.assertNotIn("PLL", said)

    def test_a_system_runs_on_one(self):
        """The port's rate follows from it: a word of 10 bits at 115,200 Hz takes 86.8 us."""
        user = "hps_0.h2f_user0_clock"
        processor = {**BASE[1][2], "S2FCLK_USER0CLK_Enable": "true", "S2FCLK_USER0CLK_FREQ": "40"}
        modules = [("leds", "altera_avalon_pio", {"width": "10", "direction": "Output"}),
                   ("port", "altera_up_avalon_rs232", {"AUTO_CLK_CLOCK_RATE": "0"})]
        self.write(
            sys_qsys=qsys(
                [BASE[0], ("hps_0", "altera_hps", processor), *modules],
                [*((kind, user, end) for kind, _, end in CLOCKS),
                 *((kind, user if kind == "clock" else start, end)
                   for name, *_ in modules for kind, start, end in clocked(name)),
                 ("avalon", LW, "leds.s1", 0), ("avalon", LW, "port.avalon_rs232_slave", 0x20)],
                [("leds", "leds.external_connection"), ("pins", "port.external_interface")]),
            top_v="module top(input CLOCK_50, output [9:0] LEDR);\nwire line;\n"
                  "sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .leds_export(LEDR),\n"
                  "    .pins_RXD(line), .pins_TXD(line));\nendmodule\n",
            top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                    "set_global_assignment -name VERILOG_FILE top.v\n"
                    "set_global_assignment -name QSYS_FILE sys.qsys\n")
        # The private timer counts at 200 MHz.
        self.program("uint32_t d, n;\nR32(0xFFFEC600) = ~0u; R32(0xFFFEC608) = 1;\n"
                     "for (n = 0; n < 10; n++) { R32(0xFF200020) = 'A';\n"
                     "    while (!((d = R32(0xFF200020)) & 0x8000)) {} }\n"
                     "R32(0xFF200000) = ~R32(0xFFFEC604) / 1000;")
        done = self.played("delay: 5ms")
        lamps = re.search(r"LEDR ([01]{10})", done.stdout).group(1)
        self.assertAlmostEqual(int(lamps, 2), 174, delta=4)
        self.assertEqual(self.pll_clocks(), 1)

    def test_a_frequency_that_there_is_not(self):
        self.write(sys_qsys=qsys([BASE[0], ("hps_0", "altera_hps", {
            **BASE[1][2], "S2FCLK_USER1CLK_Enable": "true", "S2FCLK_USER1CLK_FREQ": "0"})], CLOCKS),
            top_v="module top(input CLOCK_50, output [9:0] LEDR);\n"
                  "sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1));\nendmodule\n",
            top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                    "set_global_assignment -name VERILOG_FILE top.v\n"
                    "set_global_assignment -name QSYS_FILE sys.qsys\n")
        self.refused("S2FCLK_USER1CLK_FREQ is 0, expected 1 to 500 MHz", "check", "top.qsf")


class ResetRequests(SignalCase):
    # Counts its starts in the DDR3, which keeps it; the last cause is stat's bits 2 and 9.
    COUNTS = GPO + ("volatile uint32_t* starts = (uint32_t*)0x2000000;\n"
                    "if (starts[1] != 0x12345678) { starts[0] = 0; starts[1] = 0x12345678; }\n"
                    "uint32_t stat = R32(0xFFD05000);\nR32(0xFFD05000) = ~0u;\n"
                    "GPO = ++starts[0] | (stat >> 2 & 1) << 8 | (stat >> 9 & 1) << 9;")

    def requests(self, signal, program=COUNTS, **more):
        self.top(wires=f", .{signal}(KEY[0])", **more)
        self.program(program)

    def test_a_warm_one_starts_the_program_again(self):
        self.requests("f2h_warm_rst_req_n")
        self.shows(0x202, ["delay: 1ms", 'expect-leds: "0000000001"', "press: {key: 0, for: 1ms}"])

    def test_a_cold_one_resets_the_fpga_by_its_own_signal(self):
        self.requests("f2h_cold_rst_req_n",
                      body="reg [1:0] was = 0;\nassign LEDR = {gpo[9:8], was, gpo[5:0]};\n"
                           "always @(posedge CLOCK_50) was <= was | ~{cold_n, reset_n};")
        self.shows(0x1C2, ["delay: 1ms", "press: {key: 0, for: 1ms}"])

    def test_the_processor_stays_in_reset_while_it_is_asked_for(self):
        self.requests("f2h_warm_rst_req_n")
        done = self.played("delay: 1ms", "hold: {key: 0}", "delay: 30ms",
                           'expect-leds: "0000000001"', "release: {key: 0}", "delay: 5ms",
                           'expect-leds: "1000000010"')
        self.assertIn("the design holds f2h_warm_rst_req_n low: the processor stays in reset",
                      done.stderr)

    def test_a_debug_reset_is_seen_in_the_reset_manager_alone(self):
        self.requests("f2h_dbg_rst_req_n",
                      GPO + "uint32_t stat;\nGPO = 1;\n"
                      "do stat = R32(0xFFD05000); while (!stat);\nGPO = stat >> 16;")
        self.shows(4, ["delay: 1ms", "press: {key: 0, for: 1ms}"])

    def test_a_design_that_resets_for_ever_is_named(self):
        self.top("reg [7:0] n = 0;\nalways @(posedge CLOCK_50 or negedge reset_n)\n"
                 "    if (!reset_n) n <= 0; else if (n != 255) n <= n + 1;\n"
                 "assign LEDR = 0;", wires=", .f2h_warm_rst_req_n(n != 255)")
        self.program(GPO + "GPO = 1;")
        done = self.played("delay: 10ms", 'expect-leds: "0000000001"', code=1)
        self.assertIn("the design has reset the processor 10 times in turn by f2h_warm_rst_req_n",
                      done.stderr)
        self.assertLess(done.stderr.count("warm reset at"), 25)

    def test_one_that_is_open_is_none(self):
        self.top(wires=", .f2h_warm_rst_req_n()")
        self.program(self.COUNTS)
        self.shows(1, ["delay: 1ms"])


class StuckInterrupt(SignalCase):
    def test_a_line_that_stays_high_is_named(self):
        self.top(body="cyclonev_hps_interface_interrupts lines(.irq({63'd0, SW[0]} << 3));\n"
                      "assign LEDR = 0;")
        self.program(
            "R32(0xFFFED108) = 1 << 11; R32(0xFFFED848) = 0x01010101;\n"
            "R32(0xFFFEC104) = 0xFF; R32(0xFFFEC100) = 1; R32(0xFFFED000) = 1;\n"
            '__asm__ volatile("cpsie i" ::: "memory");\nfor (;;) {}\n}\n'
            "__attribute__((interrupt)) void on_irq(void) {\n"
            "    R32(0xFFFEC110) = R32(0xFFFEC10C);\n    return;")
        done = self.played("hold: {switch: [0]}", "delay: 20ms", 'expect-leds: "0000000001"',
                           code=1)
        self.assertRegex(done.stderr, r"interrupt 75.*was taken \d+ times since its line went up")


class SignalsThatNobodyUses(SignalCase):
    def test_the_primitives_rest(self):
        """Those that Quartus' options add, and peripherals of which there is no device."""
        self.top("""wire [31:0] trace; wire [17:0] address; wire [7:0] out, usb, eth, sd_en;
wire select, event_, can, stp; wire [1:0] wfe, wfi; wire [3:0] chips, ce;
cyclonev_hps_interface_tpiu_trace tpiu(.traceclk_ctl(1'b1), .trace_data(trace));
cyclonev_hps_interface_dbg_apb debug_apb(.DBG_APB_DISABLE(1'b0), .P_CLK_EN(1'b1),
    .P_CLK(CLOCK_50), .P_RDATA(32'd0), .P_READY(1'b1), .P_SLV_ERR(1'b0), .P_ADDR(address),
    .P_SEL(select));
cyclonev_hps_interface_cross_trigger cti(.trig_in(8'hFF), .trig_out(out), .clk(CLOCK_50),
    .clk_en(1'b1));
cyclonev_hps_interface_mpu_event_standby mpu_events(.eventi(KEY[0]), .evento(event_),
    .standbywfe(wfe), .standbywfi(wfi));
cyclonev_hps_interface_stm_event stm_event(.stm_event({28{SW[0]}}));
cyclonev_hps_interface_boot_from_fpga boot_from_fpga(.boot_from_fpga_ready(1'b0),
    .boot_from_fpga_on_failure(1'b0), .bsel_en(1'b0), .bsel(3'd1), .csel_en(1'b0), .csel(2'd1));
cyclonev_hps_interface_peripheral_emac emac0(.clk_rx_i(CLOCK_50), .phy_txd_o(eth));
cyclonev_hps_interface_peripheral_sdmmc sdio(.cmd_i(1'b1), .data_en(sd_en));
cyclonev_hps_interface_peripheral_qspi qspi(.mi0(1'b1), .n_ss_out(chips));
cyclonev_hps_interface_peripheral_usb usb0(.clk(CLOCK_50), .data_out_en(usb), .stp(stp));
cyclonev_hps_interface_peripheral_can can0(.rxd(1'b1), .txd(can));
cyclonev_hps_interface_peripheral_nand nand_flash(.rdy_busy(4'hF), .cebar(ce));
assign LEDR = {can, &chips, &ce, |usb | stp, |eth | |sd_en, |trace, |address | select, |out, event_,
    |wfe | |wfi};""")
        self.program("")
        self.shows(0b1110000000)

    def test_a_system_with_all_options(self):
        options = {f"{name}_Enable": "true" for name in (
            "MPU_EVENTS", "GP", "DEBUGAPB", "STM", "CTI", "TPIUFPGA", "BOOTFROMFPGA",
            "S2FCLK_COLDRST", "S2FCLK_PENDINGRST", "F2SCLK_COLDRST", "F2SCLK_DBGRST",
            "F2SCLK_WARMRST", "S2FCLK_USER0CLK", "S2FCLK_USER1CLK", "S2FCLK_USER2CLK")}
        exported = ("h2f_gp h2f_mpu_events h2f_debug_apb h2f_debug_apb_sideband "
                    "h2f_debug_apb_reset f2h_stm_hw_events h2f_cti h2f_tpiu h2f_tpiu_clock "
                    "f2h_boot_from_fpga h2f_cold_reset h2f_warm_reset_handshake can0 "
                    "emac0 emac0_md_clk emac0_gtx_clk emac0_rx_clk_in emac0_tx_clk_in "
                    "emac0_rx_reset emac0_tx_reset emac_ptp_ref_clock").split()
        self.write(sys_qsys=qsys([BASE[0], ("hps_0", "altera_hps", {
            **BASE[1][2], **options, "CAN0_PinMuxing": "FPGA",
            "EMAC0_PinMuxing": "FPGA"})],
            [*CLOCKS, ("clock", "clk_0.clk", "hps_0.h2f_debug_apb_clock"),
             ("clock", "clk_0.clk", "hps_0.h2f_cti_clock"),
             *(("reset", "clk_0.clk_reset", f"hps_0.f2h_{which}_reset_req")
               for which in ("cold", "warm", "debug"))],
            [(name, "hps_0." + name) for name in exported]),
            top_v="module top(input CLOCK_50, input [9:0] SW, output [9:0] LEDR);\n"
                  "wire [31:0] gpo, trace; wire cold_n, ask_n, event_, can, select, mdc, rx_n;\n"
                  "wire [7:0] txd;\n"
                  "assign LEDR = {can, cold_n, ask_n & rx_n, event_, select, |trace | |txd | mdc,\n"
                  "    gpo[3:0]};\n"
                  "sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1),\n"
                  "    .h2f_gp_gp_in({22'd0, SW}), .h2f_gp_gp_out(gpo),\n"
                  "    .h2f_mpu_events_eventi(1'b0), .h2f_mpu_events_evento(event_),\n"
                  "    .h2f_debug_apb_psel(select), .h2f_debug_apb_pready(1'b1),\n"
                  "    .h2f_debug_apb_sideband_pclken(1'b0), .h2f_tpiu_clk_ctl(1'b1),\n"
                  "    .h2f_tpiu_data(trace), .h2f_cti_trig_in(8'd0),\n"
                  "    .f2h_boot_from_fpga_boot_from_fpga_ready(1'b0),\n"
                  "    .f2h_stm_hw_events_stm_hwevents(28'd0), .can0_rxd(1'b1), .can0_txd(can),\n"
                  "    .emac0_phy_txd_o(txd), .emac0_md_clk_clk(mdc), .emac0_rx_clk_in_clk(1'b0),\n"
                  "    .emac0_rx_reset_reset_n(rx_n), .emac0_gmii_mdi_i(1'b1),\n"
                  "    .h2f_cold_reset_reset_n(cold_n),\n"
                  "    .h2f_warm_reset_handshake_h2f_pending_rst_req_n(ask_n));\nendmodule\n",
            top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                    "set_global_assignment -name VERILOG_FILE top.v\n"
                    "set_global_assignment -name QSYS_FILE sys.qsys\n")
        self.program(GPO + "for (;;) GPO = GPI & 0xF;")
        self.shows(0b1110000101, ["hold: {switch: [0, 2]}"])


run()
