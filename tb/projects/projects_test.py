"""projects_test.py DE1SIM FOLDER [CASE...] - projects as people have them: odd or wrong."""
import shutil
import subprocess

from case import DE1SIM, LEDS, Case, run


class Reading(Case):
    def test_a_folder_without_settings(self):
        self.write(other_v=LEDS.format("~SW").replace("top", "chosen"),
                   bench_v="module bench; chosen u (); endmodule\n")
        self.assertIn("the top module is taken to be chosen", self.leds(0x3FE, 1))

    def test_a_qpf_opens_the_revision_that_it_names_first(self):
        self.write(old_v=LEDS.format("10'd1"), top_v=LEDS.format("10'd2"),
                   **{name: "set_global_assignment -name TOP_LEVEL_ENTITY top\n"
                            f"set_global_assignment -name VERILOG_FILE {file}\n"
                      for name, file in (("old_qsf", "old.v"), ("board_qsf", "top.v"))},
                   lab_qpf='DATE = "today"\r\nPROJECT_REVISION = "board"\r\n'
                           'PROJECT_REVISION = "old"\r\n')
        for place in ("lab.qpf", "."):
            self.leds(2, project=place)
        (self.folder / "board.qsf").unlink()
        self.refused("lab.qpf: there is no board.qsf beside it, the settings of the revision that "
                     "it names", "check", "lab.qpf")

    def test_modules_that_are_not_listed(self):
        self.write(p_qsf="set_global_assignment -name TOP_LEVEL_ENTITY top\n"
                         "set_global_assignment -name VERILOG_FILE top.v\n",
                   top_v=LEDS.format("y").replace("; assign", "; wire [9:0] y; sub u(SW, y); assign"
                                                  ),
                   lib__Sub_v="module sub(input [9:0] a, output [9:0] b);\n"
                              "assign b = a; endmodule\n")
        self.assertIn("lib/Sub.v is not listed", self.leds(5, 5))

    FILL = "module fill(output [9:0] q); assign q = {}; endmodule\n"
    FILLS = "module {}(output [9:0] LEDR); fill f (LEDR); endmodule\n"

    def test_of_a_folders_modules_of_one_name_the_nearest(self):
        self.write(a__fill_v=self.FILL.format(1), b__fill_v=self.FILL.format(2),
                   b__b_v=self.FILLS.format("b"), c__fill_v=self.FILL.format(3))
        done = self.de1sim("check", ".", "--top", "b")
        self.assertIn("  b/fill.v\n", done.stdout)
        self.assertIn("3 files define fill: b/fill.v is taken, not a/fill.v, c/fill.v",
                      done.stdout)
        self.assertIn("b/fill.v is taken", self.leds(2, top="b"))

    def test_the_nearest_counts_where_files_define_more(self):
        """a.v is wanted for other, and has a fill in front of the one to take."""
        self.write(a_v="module other; endmodule\n" + self.FILL.format(1),
                   b__fill_v=self.FILL.format(2),
                   b__b_v=self.FILLS.format("b").replace("fill f", "other o (); fill f"))
        self.leds(2, top="b")

    def test_a_module_in_the_same_file_is_the_nearest(self):
        self.write(a_v=self.FILL.format(1), b_v=self.FILLS.format("b") + self.FILL.format(2))
        self.leds(2, top="b")

    def test_of_a_folders_entities_of_one_name_the_nearest(self):
        fill = ("library ieee; use ieee.std_logic_1164.all;\n"
                "entity fill is port (q : out std_logic_vector(9 downto 0)); end entity;\n"
                "architecture a of fill is begin q <= \"00000000{}\"; end architecture;\n")
        self.write(a__fill_vhd=fill.format("01"), b__fill_vhd=fill.format("10"),
                   b__b_v=self.FILLS.format("b"), c__fill_vhd=fill.format("11"))
        self.leds(2, top="b")

    def test_messages_name_files_with_blanks(self):
        self.write(**{"p_qsf": "set_global_assignment -name TOP_LEVEL_ENTITY top\n"
                               "set_global_assignment -name VERILOG_FILE \"my lab/top 1.v\"\n",
                      "my lab__top 1_v": "module top(input [9:0] SW);\nassign = SW; endmodule\n"})
        self.refused("my lab/top 1.v:2:")

    def test_a_folder_with_any_name(self):
        self.folder /= "my lab's \"\u00fc\" (1)"
        self.write(top_v=LEDS.format("SW"))
        self.leds(5, 5)

    def test_paths_of_another_machine(self):
        self.write(p_qsf="set_global_assignment -name TOP_LEVEL_ENTITY top\n"
                         "set_global_assignment -name VERILOG_FILE "
                         "\"C:/Users/me/lab1/SRC\\\\Top.V\"\n",
                   src__top_v=LEDS.format("SW"))
        self.leds(3, 3)

    def test_another_device_is_reported(self):
        """And its pins are not taken: PIN_AB12 is SW0 here."""
        self.write(p_qsf="set_global_assignment -name DEVICE EP4CE115F29C7\n"
                         "set_global_assignment -name TOP_LEVEL_ENTITY top\n"
                         "set_location_assignment PIN_AB12 -to LEDR[3]\n",
                   top_v=LEDS.format("SW"))
        self.assertIn("DEVICE is EP4CE115F29C7, not the DE1-SoC's 5CSEMA5F31C6",
                      self.leds(0b1000, 0b1000))


class Parameters(Case):
    QSF = ("set_global_assignment -name TOP_LEVEL_ENTITY top\n"
           "set_parameter -name N 5\nset_parameter -name WORD \"no\"\n"
           "set_parameter -name FLAG true\nset_parameter -name N 3 -to \"sub:u\"\n")

    def test_of_a_verilog_top(self):
        self.write(p_qsf=self.QSF, top_v="module top #(parameter N = 1, FLAG = 0, WORD = \"yes\")"
                   "(output [N - 1:0] LEDR);\n"
                   "assign LEDR = {FLAG, WORD == \"no\", 3'd5}; endmodule\n")
        self.assertIn("p.qsf:5: set_parameter of an instance is passed over",
                      self.leds(0b11101))

    def test_of_a_vhdl_top(self):
        self.write(p_qsf=self.QSF, top_vhd="library ieee; use ieee.std_logic_1164.all;\n"
                   "entity top is generic (n : integer := 1; flag : boolean := false;\n"
                   "  word : string := \"yes\");\n"
                   "port (LEDR : out std_logic_vector(n - 1 downto 0)); end entity;\n"
                   "architecture a of top is begin LEDR(2 downto 0) <= \"101\";\n"
                   "LEDR(3) <= '1' when word = \"no\" else '0';\n"
                   "LEDR(4) <= '1' when flag else '0'; end architecture;\n")
        self.leds(0b11101)

    # Intel's IP has global ones.
    IP_QSF = ("set_global_assignment -name TOP_LEVEL_ENTITY top\n"
              "set_parameter -name CYCLONEII_SAFE_WRITE RESTRUCTURE\n"
              "set_parameter -name MASK 3\nset_parameter -name DEPTH 5\n")

    def says_which_are_passed_over(self, said):
        self.assertIn("p.qsf:2: set_parameter CYCLONEII_SAFE_WRITE is passed over: "
                      "top has no such parameter", said)
        self.assertIn("p.qsf:4: set_parameter DEPTH is passed over", said)
        self.assertNotIn("MASK", said)

    def test_those_that_a_verilog_top_has_not(self):
        self.write(p_qsf=self.IP_QSF, top_v=LEDS.format("SW ^ MASK").replace(
            "top(", "top #(parameter MASK = 0) ("))
        self.says_which_are_passed_over(self.leds(0b111, 0b100))

    def test_those_that_a_vhdl_top_has_not(self):
        text = ("library ieee; use ieee.std_logic_1164.all; use ieee.numeric_std.all;\n"
                "entity top is {}port (LEDR : out std_logic_vector(9 downto 0)); end entity;\n"
                "architecture a of top is begin\n"
                "LEDR <= std_logic_vector(to_unsigned({}, 10)); end architecture;\n")
        self.write(p_qsf=self.IP_QSF, top_vhd=text.format("generic (Mask : integer := 1); ",
                                                          "mask"))
        self.says_which_are_passed_over(self.leds(3))
        (self.folder / "p.qsf").write_text(self.IP_QSF.replace("MASK", "maSK"))
        self.says_which_are_passed_over(self.leds(3))
        self.write(p_qsf=self.IP_QSF.replace("set_parameter -name MASK 3\n", "\n"),
                   top_vhd=text.format("", "9"))
        self.says_which_are_passed_over(self.leds(9))

    def test_a_value_that_does_not_fit_is_an_error(self):
        self.write(p_qsf=self.IP_QSF.replace("MASK 3", "MASK 0"), top_v=LEDS.format(
            "SW ^ {MASK{1'b1}}").replace("top(", "top #(parameter MASK = 1) ("))
        self.refused("top.v:1:")


class PulledInputs(Case):
    def test_pulled_inputs_in_two_levels_of_modules(self):
        """As wizards write them: what is connected counts, and an open one is as it is pulled."""
        self.write(top_v="""module top(input [9:0] SW, output [9:0] LEDR);
outer a(.d(SW[3:0]), .en(SW[4]), .q(LEDR[4:0]));
outer b(.d(SW[3:0]), .en(), .q(LEDR[9:5])); endmodule
module outer(d, en, off, q); input [3:0] d; input en, off; output [4:0] q;
tri0 [3:0] d; tri1 en; tri0 off;
inner i(.d(d), .en(en), .off(off), .q(q)); endmodule
module inner(d, en, off, both, q); input [3:0] d; input en, off; input [1:0] both;
output [4:0] q; tri0 [3:0] d; tri1 en; tri0 off; tri1 [1:0] both;
assign q = {off, d & {en, en, both}}; endmodule
""")
        self.leds(0b00111_00011, 0b00111)
        self.leds(0b01101_01101, 0b11101)


class InoutPins(Case):
    """What a design does not drive, the pull-ups of the headers hold at 1."""

    def test_one_pin_driven_and_no_z_anywhere(self):
        self.write(top_v="module top(inout [35:0] GPIO_0, output [9:0] LEDR);\n"
                         "assign GPIO_0[6] = 0; assign LEDR = GPIO_0[10:1]; endmodule\n")
        self.leds(0b1111011111)

    def test_parts_driven_by_all_kinds_of_drivers(self):
        self.write(top_v="module seven(x, y); input x; output [6:0] y; assign y = {7{x}};\n"
                         "endmodule\n"
                         "module deep(inout [3:0] io); assign io[1] = 0, io[2] = 1; endmodule\n"
                         "module top(SW, LEDR, GPIO_0, GPIO_1);\n"
                         "input [9:0] SW; output [9:0] LEDR; inout [35:0] GPIO_0, GPIO_1;\n"
                         "parameter P = 1; genvar i; wire spare;\n"
                         "generate for (i = 0; i < 2; i = i + 1) begin : each\n"
                         "assign GPIO_0[2 * i] = SW[i]; end endgenerate\n"
                         "seven a (SW[2], GPIO_0[10:4]), b (.x(SW[3]), .y(GPIO_0[17:11]));\n"
                         "if (P) seven c (.x(SW[2]), .y({spare, GPIO_0[35:30]}));\n"
                         "deep d (.io(GPIO_1[3:0]));\n"
                         "assign GPIO_1[5] = SW[4] ? 1'b0 : 1'bz;\n"
                         "assign GPIO_1[8] = SW[4] ? 1'b0 : 1'bz;\n"
                         "assign LEDR[4:0] = {GPIO_0[30], GPIO_0[18], GPIO_0[11], GPIO_0[4:3]};\n"
                         "assign LEDR[9:5] = {GPIO_1[5], GPIO_1[3:0]}; endmodule\n")
        self.leds(0b11101_01001)
        self.leds(0b11101_11011, 0b00100)
        self.leds(0b01101_01101, 0b11000)

    def test_a_bus_with_enables_of_its_own(self):
        self.write(top_v="module top(inout [35:0] GPIO_0, input [9:0] SW, output [9:0] LEDR);\n"
                         "wire e = SW[0]; assign GPIO_0[3] = e ? 1'b0 : 1'bz;\n"
                         "assign GPIO_0[35:8] = 28'bz; assign GPIO_0[5] = SW[1];\n"
                         "assign LEDR = GPIO_0[9:0]; endmodule\n")
        self.leds(0b1111011111)
        self.leds(0b1111110111, 3)

    def test_ports_with_other_numbers_of_bits_in_the_order_of_the_ports(self):
        self.write(top_v="""module five(inout [4:0] io, input e);
assign io = e ? 5'b00101 : 5'bz;
endmodule
module top(inout [35:0] GPIO_0, inout [35:0] GPIO_1, input [9:0] SW, output [9:0] LEDR);
five #() a(GPIO_0[1:0], SW[0]),
         b(GPIO_1, SW[1]);
assign LEDR = {GPIO_1[5:0], GPIO_0[3:0]};
endmodule
""")
        self.leds(0b100101_1101, 3)
        self.leds(0b111111_1111)

    # 12030: "The extra bits will be left dangling."
    def test_an_output_leaves_the_upper_bits_of_a_wider_wire_to_others(self):
        self.write(top_v="""module one(output q);
assign q = 1'b1;
endmodule
module top(input [9:0] SW, output [9:0] LEDR);
wire [2:0] w;
one one(.q(w));
assign w[1] = SW[0];
assign w[2] = !SW[0];
assign LEDR = {7'd0, w};
endmodule
""")
        self.leds(0b011, 1)
        self.leds(0b101)


class Clocks(Case):
    def test_keys_and_dividers(self):
        self.write(top_v="module top(input CLOCK_50, input [3:0] KEY, output [9:0] LEDR);\n"
                         "reg [4:0] n = 0; always @(negedge KEY[0]) n <= n + 1;\n"
                         "reg d = 0; always @(posedge CLOCK_50) d <= ~d;\n"
                         "reg [4:0] m = 0; always @(posedge d) m <= m == 20 ? 20 : m + 1;\n"
                         "assign LEDR = {m, n}; endmodule\n")
        self.plays("press: {key: 0, for: 1ms}", "delay: 1ms", "press: {key: 0, for: 1ms}",
                   "delay: 50ms", 'expect-leds: "1010000010"')

    def test_plls_have_their_true_ratio(self):
        pll = ("altpll p (.inclk({1'b0, CLOCK_50}), .clk(c));\n"
               'defparam p.inclk0_input_frequency = 20000, p.clk0_multiply_by = 3,\n'
               '  p.clk0_divide_by = 5, p.port_clk0 = "PORT_USED", p.width_clock = 5;\n')
        self.write(top_v="module top(input CLOCK_50, output [9:0] LEDR);\nwire [4:0] c;\n" + pll +
                         "reg [15:0] a = 0, b = 0; reg done = 0;\n"
                         "always @(posedge CLOCK_50) if (a != 1000) a <= a + 1; else done <= 1;\n"
                         "always @(posedge c[0]) if (!done) b <= b + 1;\n"
                         "assign LEDR = b; endmodule\n")
        self.checked("PLL: 30.000000 MHz")
        self.leds(601, wait="50ms")  # a count is seen as a lamp that flickers


class WithoutAPicture(Case):
    def test_the_monitor_says_nothing_of_a_top_without_vga(self):
        self.write(top_v=LEDS.format("SW"))
        said = self.leds(1, 1, wait="1010ms")
        self.assertNotIn("no signal", said)
        self.assertNotIn("found no picture", said)


class Registers(Case):
    def test_structures_are_as_wide_as_their_members(self):
        self.write(top_sv="""module top(input CLOCK_50, input [3:0] KEY, output [9:0] LEDR);
typedef struct packed { logic [9:0] x; logic [8:0] y; } place;
place places[3];
always_ff @(posedge CLOCK_50 or negedge KEY[0])
    if (!KEY[0]) for (int i = 0; i < 3; i++) places[i] <= '{x: 10'(i * 3), y: 9'd7};
    else places[2].x <= places[2].x | 10'd1;
assign LEDR = places[2].x;
endmodule
""")
        self.plays("press: {key: 0, for: 1ms}", "delay: 1ms", 'expect-leds: "0000000111"')


class Wrong(Case):
    def test_no_such_place(self):
        self.refused("nowhere.qsf: is not there", "check", "nowhere.qsf")

    def test_an_empty_folder(self):
        self.refused("no Verilog or VHDL files found here")

    def test_no_module_has_the_boards_pins(self):
        self.write(a_v="module a(input x); endmodule\n")
        self.refused("no top module is named; no module has the board's pins")

    def test_two_tops(self):
        self.write(a_v=LEDS.format("SW"), b_v=LEDS.format("SW").replace("top", "top2"))
        self.refused("two top modules are possible, choose by --top")

    def test_a_port_of_impossible_width(self):
        for width in "[1024:0]", "[0:99999]":
            self.write(top_v=f"module top(input [9:0] SW, inout {width} GPIO_0); endmodule\n")
            self.refused("expected at most 1024")

    def test_garbage(self):
        (self.folder / "top.v").write_bytes(bytes(range(256)) * 4000)
        self.refused("no module has the board's pins")

    def with_verilator(self, text, *words):
        """de1sim WORDS with another Verilator, a script of this text."""
        program = self.folder / "bin" / "verilator"
        program.parent.mkdir(exist_ok=True)
        program.write_text(f"#!/bin/sh\n{text}\n")
        program.chmod(0o755)
        return subprocess.run([DE1SIM, *words], cwd=self.folder, capture_output=True, text=True,
                              env={"PATH": f"{program.parent}:/usr/bin:/bin",
                                   "XDG_CACHE_HOME": str(self.folder / "cache")})

    def test_no_verilator_and_an_old_one(self):
        self.write(top_v=LEDS.format("SW"))
        for text, message in (
                ("exit 127", "verilator is not installed: apt install verilator g++"),
                ("echo Verilator 4.038 2020", "Verilator 4.038 is installed, expected 5.006 or")):
            done = self.with_verilator(text, "check", ".")
            self.assertEqual(done.returncode, 2)
            self.assertIn(message, done.stderr)

    def test_another_verilator(self):
        """Its library is compiled once, into the user's cache."""
        self.write(top_v=LEDS.format("SW"),
                   s_yaml="name: x\nversion: 1\nsteps:\n  - delay: 1ms\n"
                          '  - expect-leds: "0000000000"\n')
        text = ('[ "$1" = --version ] && echo Verilator 5.999 2099 && exit\n'
                f'exec {shutil.which("verilator")} "$@"')
        for _ in range(2):
            done = self.with_verilator(text, "run", "s.yaml", "--project", ".", "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(list(self.folder.glob("cache/de1sim/runtime/*/*.a"))), 1)

    def test_constants_among_what_an_output_is_connected_with_are_open(self):
        self.write(top_v="module top(input [9:0] SW, output [9:0] LEDR);\n"
                         "sub s(.a(SW[7:0]), .q({1'b0, LEDR[2:0], 3'd5, LEDR[3]}));\n"
                         "assign LEDR[9:4] = 0;\nendmodule\n"
                         "module sub(input [7:0] a, output [7:0] q); assign q = ~a; endmodule\n")
        self.leds(0b1111)

    def test_elements_of_an_array_of_two_dimensions_have_a_driver_each(self):
        self.write(top_v="module top(input [9:0] SW, output [9:0] LEDR);\n"
                         "wire [4:0] v [0:1][0:1];\n"
                         "genvar i, j; generate for (i = 0; i < 2; i = i + 1)\n"
                         "for (j = 0; j < 2; j = j + 1) begin : a\n"
                         "assign v[i][j] = 5 * i + j; end endgenerate\n"
                         "assign LEDR = {v[1][1], v[0][1]};\nendmodule\n")
        self.leds(0b0011000001)

    def test_a_file_that_is_found_is_system_verilog_where_the_settings_say_so(self):
        self.write(p_qsf="set_global_assignment -name VERILOG_INPUT_VERSION SYSTEMVERILOG_2005\n"
                         "set_global_assignment -name VERILOG_FILE top.v\n"
                         "set_global_assignment -name TOP_LEVEL_ENTITY top\n",
                   top_v="module top(output [9:0] LEDR);\nsub s(LEDR);\nendmodule\n",
                   sub_v="module sub(output [9:0] q);\n"
                         "for (genvar i = 0; i < 10; i++) assign q[i] = i % 2;\nendmodule\n")
        self.leds(0b1010101010)

    def test_the_native_processor(self):
        self.write(top_v=LEDS.format("SW"), s_yaml="name: x\nversion: 1\nsteps: [delay: 1ms]\n")
        self.refused("--cpu: native is this project's own firmware", "run", "s.yaml", "--project",
                     ".", "--cpu", "native")


if __name__ == "__main__":
    run()
