"""vhdl_test.py DE1SIM FOLDER [CASE...] - projects with VHDL, by GHDL."""
import os
import pathlib
import re
import shutil
import subprocess

from case import DE1SIM, GHDL, LEDS, Case, run

USE = "library ieee; use ieee.std_logic_1164.all; use ieee.numeric_std.all;\n"
TOP = USE + """{}entity Lab is port (
  CLOCK_50 : in std_logic; SW : in std_logic_vector(9 downto 0);
  LEDR : out std_logic_vector(9 downto 0); GPIO_0 : inout std_logic_vector(35 downto 0)); end;
architecture a of Lab is
{}
begin
{}
end;
"""
COUNT = USE + """entity count is generic (LAST : integer := 3);
port (clk : in std_logic; q : out std_logic_vector(3 downto 0)); end;
architecture a of count is signal n : unsigned(3 downto 0) := (others => '0'); begin
  process (clk) begin
    if rising_edge(clk) then if n /= LAST then n <= n + 1; end if; end if;
  end process;
  q <= std_logic_vector(n);
end;
"""
PAD = USE + """entity pad is port (clk, oe : in std_logic; d : in std_logic_vector(2 downto 0);
q : out std_logic_vector(2 downto 0); io : inout std_logic_vector(2 downto 0)); end;
architecture a of pad is begin
q <= io;
process (clk{0}) begin
{1}
end process; end;
"""
QSF = "set_global_assignment -name TOP_LEVEL_ENTITY lab\n"


class Vhdl(Case):
    def test_entities_of_several_files_in_any_order(self):
        self.write(p_qsf=QSF + "set_global_assignment -name VHDL_FILE a.vhd\n"
                   "set_global_assignment -name VHDL_FILE count.vhd\n"
                   "set_global_assignment -name VHDL_FILE words.vhd\n",
                   a_vhd=TOP.format("use work.words.all;\n", "",
                                    "c : entity work.count generic map (LAST => 9)\n"
                                    "  port map (clk => CLOCK_50, q => LEDR(3 downto 0));\n"
                                    "LEDR(9 downto 4) <= MARK;"),
                   count_vhd=COUNT,
                   words_vhd=USE + "package words is constant MARK : std_logic_vector(5 downto 0)"
                                   ' := "101010"; end words;\n')
        self.leds(0b1010101001)

    def test_operations_give_what_ghdls_own_simulation_gives(self):
        source = pathlib.Path(__file__).parent / "vhdl" / "operations.vhd"
        shutil.copy(source, self.folder / "a.vhd")
        bench = self.folder / "bench"
        bench.mkdir()
        (bench / "bench.vhd").write_text(
            USE + "entity bench is end; architecture a of bench is\n"
            "signal clk : std_logic := '0'; signal leds : std_logic_vector(9 downto 0); begin\n"
            "u : entity work.operations port map (clk, leds);\n"
            "process begin for i in 1 to 2100 loop wait for 10 ns; clk <= not clk; end loop;\n"
            "report \"leds \" & to_string(leds); wait; end process; end;\n")
        for words in (["-a", "--std=08", source, "bench.vhd"], ["-r", "--std=08", "bench"]):
            done = subprocess.run(["ghdl", *words], cwd=bench, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        leds = re.search("leds ([01]{10})", done.stdout + done.stderr).group(1)
        shutil.rmtree(bench)
        self.leds(int(leds, 2), wait="20ms")

    def test_a_folder_and_pins_that_are_not_driven(self):
        self.write(a_vhd=TOP.format("", "", "GPIO_0(3) <= SW(3) when SW(0) = '1' else 'Z';\n"
                                    "LEDR <= GPIO_0(9 downto 0);"))
        self.assertIn("the top module is taken to be Lab", self.leds(0x3FF))
        self.leds(0x3F7, 1)

    def pads(self, body, sensitive=""):
        """Pads of three bits on GPIO_0, in an entity in between, beside a pin of the top's own."""
        between = PAD.replace("pad", "pads").replace("2 downto", "5 downto")
        between = between[:between.index("q <=")] + (
            "a : entity work.pad\n"
            "  port map (clk, oe, d(2 downto 0), q(2 downto 0), io(2 downto 0));\n"
            "b : entity work.pad\n"
            "  port map (clk, oe, d(5 downto 3), q(5 downto 3), io(5 downto 3)); end;\n")
        self.write(a_vhd=TOP.format("", "", "p : entity work.pads port map (CLOCK_50, SW(9),\n"
                                    "  SW(5 downto 0), LEDR(5 downto 0), GPIO_0(6 downto 1));\n"
                                    "GPIO_0(0) <= 'Z' when SW(8) = '1' else '0';\n"
                                    "LEDR(9) <= GPIO_0(0); LEDR(8 downto 6) <= \"000\";"),
                   pads_vhd=between, pad_vhd=PAD.format(sensitive, body))

    def test_pins_released_in_a_clocked_process(self):
        self.pads("if rising_edge(clk) then\n"
                  "if oe = '1' then io <= d; else io <= (others => 'Z'); end if; end if;")
        self.leds(0b0000101001, 0b1000101001)
        self.leds(0b1000111111, 0b0100101001)
        self.plays("hold: {switch: 8}", "set-pins: {gpio_0: [3, 4], level: low}", "delay: 20ms",
                   'expect-leds: "1000110011"')

    def test_pins_released_in_a_process_without_a_clock(self):
        self.pads("io <= (others => 'Z'); io(0) <= d(0) and not oe; case d(1 downto 0) is\n"
                  "when \"10\" => io(2 downto 1) <= \"0Z\"; when \"00\" => null;\n"
                  "when others => io(2) <= oe; end case;", ", oe, d")
        self.leds(0b0000010110, 0b0000010000)  # 10 and 00
        self.leds(0b1000011011, 0b0100001011)  # 01 and 11

    def test_verilog_in_vhdl_and_vhdl_in_verilog(self):
        self.write(p_qsf=QSF + "set_global_assignment -name VHDL_FILE a.vhd\n"
                   "set_global_assignment -name VERILOG_FILE b.v\n"
                   "set_global_assignment -name VHDL_FILE count.vhd\n",
                   a_vhd=TOP.format("", "component Middle port (clk : in std_logic;\n"
                                    "  q : out std_logic_vector(3 downto 0)); end component;",
                                    "LEDR(9 downto 4) <= SW(9 downto 4);\n"
                                    "m : Middle port map (CLOCK_50, LEDR(3 downto 0));"),
                   b_v="module middle(input clk, output [3:0] q); wire [3:0] n;\n"
                       "count c (.clk(clk), .q(n)); assign q = ~n; endmodule\n",
                   count_vhd=COUNT)
        self.leds(0b0000011100, 0b0000010000)

    def test_an_array_of_wide_words_by_an_index(self):
        self.write(p_qsf=QSF + "set_global_assignment -name VHDL_FILE a.vhd\n",
                   a_vhd=TOP.format("", "type words is array (0 to 3) of "
                                    "std_logic_vector(39 downto 0);\nsignal w : words;",
                                    "w(0) <= 30x\"1\" & SW; w(1) <= 30x\"2\" & not SW;\n"
                                    "w(2) <= SW & 30x\"3\"; w(3) <= not SW & 30x\"4\";\n"
                                    "LEDR <= w(to_integer(unsigned(SW(1 downto 0))))"
                                    "(19 downto 10) xor w(to_integer(unsigned(SW(9 downto 8))))"
                                    "(9 downto 0);"))
        self.leds(0b0000000011, 0b0000000011)
        self.leds(0b0000000001, 0b1000000001)

    def test_a_signal_of_the_name_that_ghdl_gives_a_net(self):
        self.write(p_qsf=QSF + "set_global_assignment -name VHDL_FILE a.vhd\n"
                   "set_global_assignment -name VERILOG_FILE b.v\n",
                   a_vhd=TOP.format("", "component b port (a : in std_logic_vector(9 downto 0);\n"
                                    "  q : out std_logic_vector(9 downto 0)); end component;\n"
                                    "signal u_q : std_logic_vector(9 downto 0);",
                                    "u : b port map (SW, u_q); LEDR <= u_q;"),
                   b_v="module b(input [9:0] a, output [9:0] q); assign q = 40; endmodule\n")
        self.leds(40)

    def sets(self, instances):
        """Verilog around an entity with generics of all types."""
        self.write(top_v="module top(input CLOCK_50, input [9:0] SW, output [9:0] LEDR);\n" +
                   instances + "\nendmodule\n",
                   foo_vhd=USE + "entity foo is generic (W : integer := 3; Neg : integer := -1;\n"
                   "B : boolean := false; V : std_logic_vector(2 downto 0) := \"010\";\n"
                   "S : string := \"ab\"; L : std_logic := '0'; T : time := 1 ns);\n"
                   "port (q : out std_logic_vector(W - 1 downto 0); i : in std_logic); end;\n"
                   "architecture a of foo is\n"
                   "signal all_of_them : unsigned(15 downto 0); begin\n"
                   "all_of_them <= to_unsigned(Neg + 1, 7) & unsigned(V) & L &\n"
                   "  to_unsigned(character'pos(S(S'left)) - 97, 4) & i;\n"
                   "q <= std_logic_vector(all_of_them(W - 1 downto 0)) when not B else\n"
                   "(others => i); end;\n")

    def test_generics_that_verilog_sets(self):
        self.sets("foo #(.W(4), .S(\"dx\")) a (.q(LEDR[3:0]), .i(SW[0]));\n"
                  "foo b (LEDR[6:4], SW[1]);\n"
                  "foo #(.W(10), .NEG(0), .L(1), .V(4'd5)) c (d, SW[1]); wire [9:0] d;\n"
                  "assign LEDR[9:7] = {d[9], d[6:5]};")
        self.leds(0b111_001_0110, 2)
        self.leds(0b111_000_0111, 1)

    def test_generics_by_parameters_and_in_two_steps(self):
        self.sets("parameter N = 2; genvar g; generate for (g = 0; g < N; g = g + 1) begin : x\n"
                  "foo #(.w(N + 1), .b(g)) u (.q(LEDR[3*g+2 -: 3]), .i(SW[g])); end endgenerate\n"
                  "foo u (LEDR[8:6], 1'b0); defparam u.S = \"h\"; assign LEDR[9] = 1;")
        self.leds(0b1110_111_001, 3)

    def test_ports_that_verilog_writes_in_another_case(self):
        self.write(top_v="module top(input [9:0] SW, output [9:0] LEDR, input CLOCK_50);\n"
                         "Pad p (.A_IN(SW[4:0]), .Q(LEDR[4:0])),\n"
                         "    q (.a_in(SW[9:5]), .q(LEDR[9:5])); endmodule\n",
                   pad_vhd=USE + "entity PAD is port (A_In : in std_logic_vector(4 downto 0);\n"
                                 "q : out std_logic_vector(4 downto 0)); end;\n"
                                 "architecture x of pad is begin q <= not a_in; end;\n")
        self.leds(0b1111011110, 0b0000100001)

    def test_a_generic_that_cannot_be_set(self):
        self.sets("foo #(.T(2)) a (.q(LEDR[2:0]), .i(SW[0]));")
        self.refused("foo.vhd: entity foo: generic T cannot have the value 32'sh2 from Verilog, "
                     "expected a number, boolean, std_logic, a vector of bits or a string")

    def test_a_generic_that_is_not_there(self):
        self.sets("foo #(.WIDTH(2)) a (.q(LEDR[2:0]), .i(SW[0]));")
        self.refused("top.v:2: the module that is instanced has no parameter WIDTH")

    def test_a_memory_by_the_library_of_components(self):
        self.write(a_vhd=TOP.format(
            "library altera_mf; use altera_mf.altera_mf_components.all;\n"
            "library lpm; use lpm.lpm_components.all;\n",
            "signal q : std_logic_vector(7 downto 0);",
            "m : altsyncram generic map (operation_mode => \"ROM\", width_a => 8,\n"
            "    widthad_a => 2, numwords_a => 4, init_file => \"words.mif\")\n"
            "  port map (clock0 => CLOCK_50, address_a => SW(1 downto 0), q_a => q);\n"
            "LEDR <= \"00\" & q;"),
            words_mif="WIDTH=8; DEPTH=4; ADDRESS_RADIX=DEC; DATA_RADIX=HEX;\n"
                      "CONTENT BEGIN 0: 11; 1: a5; 2: 3c; END;\n")
        self.leds(0x3C, 2)
        self.checked("words.mif")

    def test_components_of_all_libraries(self):
        self.write(a_vhd=TOP.format(
            "library lpm; use lpm.lpm_components.all;\n"
            "library altera_mf; use altera_mf.altera_mf_components.all;\n"
            "library altera; use altera.altera_primitives_components.all;\n"
            "library altera_lnsim; use altera_lnsim.altera_lnsim_components.all;\n",
            "signal words : std_logic_2d(1 downto 0, 3 downto 0);\n"
            "signal p : std_logic_vector(5 downto 0); signal q : std_logic;",
            "g : for i in 0 to 3 generate\n"
            "  words(0, i) <= SW(i); words(1, i) <= SW(i + 4); end generate;\n"
            "a : lpm_mux generic map (lpm_size => 2, lpm_width => 4, lpm_widths => 1)\n"
            "  port map (data => words, sel => SW(9 downto 9), result => LEDR(3 downto 0));\n"
            "b : lpm_mult generic map (lpm_widtha => 3, lpm_widthb => 3, lpm_widthp => 6)\n"
            "  port map (dataa => SW(2 downto 0), datab => SW(5 downto 3), result => p);\n"
            "c : lcell port map (a_in => p(5), a_out => LEDR(9));\n"
            "d : dffe port map (SW(0), CLOCK_50, '1', '1', '1', q);\n"
            "e : tri port map (a_in => q, oe => SW(1), a_out => GPIO_0(3)); LEDR(8) <= GPIO_0(3);\n"
            "f : altddio_out generic map (width => 1) port map (datain_h => SW(0 downto 0),\n"
            "  datain_l => SW(0 downto 0), outclock => CLOCK_50, dataout => LEDR(7 downto 7));\n"
            "h : lpm_add_sub generic map (lpm_width => 3) port map (\n"
            "  dataa => SW(2 downto 0), datab => SW(5 downto 3), result => LEDR(6 downto 4));"))
        self.leds(0b11_1_100_0010, 0b10_0010_1111)  # 7 * 5 = 35, 7 + 5 = 12
        self.leds(0b00_0_001_1010, 0b00_1111_1010)  # 2 * 7 = 14, 2 + 7 = 9

    def test_words_of_altera_mf_as_an_array_of_two_dimensions(self):
        self.write(a_vhd=TOP.format(
            "library altera_mf; use altera_mf.altera_mf_components.all;\n",
            "signal words : altera_mf_logic_2d(2 downto 0, 3 downto 0);",
            "g : for i in 0 to 3 generate\n"
            "  words(0, i) <= SW(i); words(1, i) <= SW(i + 4); words(2, i) <= '1'; end generate;\n"
            "a : parallel_add generic map (width => 4, size => 3, widthr => 10)\n"
            "  port map (data => words, result => LEDR);\n"
            "GPIO_0 <= (others => 'Z');"))
        self.leds(15 + 7 + 9, 0x79)

    def test_components_as_a_wizards_file_declares_them(self):
        """With names in any case, and two of one name and of different widths."""
        ff = (USE + "library lpm; use lpm.all;\nentity ff{0} is port (clock : in std_logic;\n"
              "data : in std_logic_vector({1} downto 0);\n"
              "q : out std_logic_vector({1} downto 0)); end;\n"
              "architecture SYN of ff{0} is\nCOMPONENT lpm_ff GENERIC (LPM_Width : NATURAL;\n"
              "lpm_type : STRING := \"\"); PORT (Clock : IN STD_LOGIC;\n"
              "Data : IN STD_LOGIC_VECTOR ({1} DOWNTO 0);\n"
              "q : OUT STD_LOGIC_VECTOR ({1} DOWNTO 0));\n"
              "END COMPONENT;\nbegin u : lpm_ff GENERIC MAP (lpm_width => {1} + 1)\n"
              "PORT MAP (clock => clock, data => data, q => q); end;\n")
        self.write(a_vhd=TOP.format(
            "library altera_mf; use altera_mf.all;\n",
            "component scfifo generic (LPM_NUMWORDS, LPM_WIDTH, LPM_WIDTHU : natural;\n"
            "  lpm_showahead, USE_EAB : string); port (clock, wrreq, rdreq : in std_logic;\n"
            "  data : in std_logic_vector(2 downto 0); q : out std_logic_vector(2 downto 0));\n"
            "end component;",
            "f : scfifo generic map (4, 3, 2, \"ON\", use_eab => \"ON\")\n"
            "  port map (clock => CLOCK_50, wrreq => '1', rdreq => '1',\n"
            "  data => SW(9 downto 7), q => LEDR(9 downto 7));\n"
            "a : entity work.ff2 port map (CLOCK_50, SW(6 downto 5), LEDR(6 downto 5));\n"
            "b : entity work.ff5 port map (CLOCK_50, SW(4 downto 0), LEDR(4 downto 0));"),
            b_vhd=ff.format(2, 1) + ff.format(5, 4))
        self.leds(0b1011001011, 0b1011001011)

    def test_a_file_in_a_library_of_the_projects_own(self):
        for option in "lib/words.vhd -library mine", "-library mine lib/words.vhd":
            self.write(p_qsf=QSF + f"set_global_assignment -name VHDL_FILE {option}\n"
                       "set_global_assignment -name VHDL_FILE lab.vhd\n",
                       lab_vhd=TOP.format("library mine; use mine.words.all;\n", "",
                                          "LEDR <= WORD; GPIO_0 <= (others => 'Z');"),
                       lib__words_vhd=USE + "package words is constant WORD : "
                       'std_logic_vector(9 downto 0) := "1000000101"; end;\n')
            self.checked("lab.vhd")
        self.leds(0b1000000101)

    def test_an_entity_of_a_library_that_has_verilog_in_it(self):
        """As the wizard writes a PLL in VHDL."""
        self.write(p_qsf=QSF + "set_global_assignment -name VHDL_FILE lab.vhd\n"
                   "set_global_assignment -library pll -name VHDL_FILE pll.vhd\n"
                   "set_global_assignment -library pll -name VERILOG_FILE pll/pll_0002.v\n",
                   lab_vhd=TOP.format("library pll; use pll.all;\n", "",
                                      "p : entity pll.pll port map (SW, LEDR);"),
                   pll_vhd=USE + "entity pll is port (a : in std_logic_vector(9 downto 0);\n"
                                 "q : out std_logic_vector(9 downto 0)); end;\n"
                                 "architecture rtl of pll is component pll_0002 is port (\n"
                                 "a : in std_logic_vector(9 downto 0);\n"
                                 "q : out std_logic_vector(9 downto 0)); end component; begin\n"
                                 "u : component pll_0002 port map (a => a, q => q); end;\n",
                   pll__pll_0002_v="module pll_0002(input wire [9:0] a, output wire [9:0] q);\n"
                                   "assign q = ~a; endmodule\n")
        self.leds(0b1111111010, 5)

    def test_a_crash_of_ghdl_is_called_one(self):
        self.write(lab_vhd=TOP.format("", "type words is array (0 to 1) of std_logic;\n"
                                          "shared variable m : words;",
                                      "process (CLOCK_50) begin if rising_edge(CLOCK_50) then\n"
                                      "m(to_integer(unsigned(SW(0 downto 0)))) := SW(1);\n"
                                      "end if; end process;\n"
                                      "LEDR(0) <= m(to_integer(unsigned(SW(0 downto 0))));"))
        if GHDL < 3:
            self.refused("lab.vhd: GHDL 2.0.0 crashed on this VHDL; a newer GHDL may take it")
        else:
            self.checked("lab.vhd")

    def test_an_error_has_its_place(self):
        self.write(a_vhd=TOP.format("", "", "LEDR <= gone;"))
        self.refused('a.vhd:8:9: no declaration for "gone"')

    def test_a_component_that_nothing_defines(self):
        self.write(a_vhd=TOP.format("", "component gone port (x : in std_logic); end component;",
                                    "g : gone port map (SW(0)); LEDR <= SW;"))
        self.refused("component gone: no file defines it")

    def test_without_ghdl(self):
        self.write(a_vhd=TOP.format("", "", "LEDR <= SW;"))
        done = subprocess.run([DE1SIM, "check", "."], cwd=self.folder, capture_output=True,
                              text=True, env=dict(os.environ, PATH=str(self.folder)))
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.splitlines()[-1],
                         "de1sim: the project has VHDL, for which ghdl is not "
                         "installed: apt install ghdl")

    def test_an_entity_by_a_component_declaration(self):
        self.write(a_vhd=TOP.format("", "component count is generic (LAST : integer);\n"
                                    "port (clk : in std_logic;\n"
                                    "q : out std_logic_vector(3 downto 0));\n"
                                    "end component;",
                                    "c : count generic map (9)\n"
                                    "  port map (CLOCK_50, LEDR(3 downto 0));\n"
                                    "LEDR(9 downto 4) <= \"000000\";"), count_vhd=COUNT)
        self.leds(0b1001, wait="20ms")

    def test_a_file_with_an_error_that_nobody_needs(self):
        self.write(a_vhd=TOP.format("", "", "LEDR <= SW;"),
                   skeleton_vhd=USE + "entity skeleton is port ( ); end;\n",
                   older_vhd=TOP.format("", "", "LEDR <= gone;"))
        self.leds(5, 5)

    def test_an_entity_that_ghdl_refuses_is_named_with_its_line(self):
        self.write(a_vhd=TOP.format("", "component part is generic (n : integer := 8);\n"
                                    "port (a : in std_logic; q : out std_logic); end component;",
                                    "p : part generic map (4) port map (SW(0), LEDR(0));\n"
                                    'LEDR(9 downto 1) <= "000000000";'),
                   part_vhd=USE + "entity part is generic (n : integer := 8);\n"
                            "port (a : in std_logic; q : out std_logic); end;\n"
                            "architecture x of part is begin\nq <= a and gone; end;\n")
        self.refused('part.vhd:5:12: no declaration for "gone"')

    # GHDL says of it only that it is outdated.
    def test_an_error_in_the_body_of_a_package_has_its_place(self):
        self.write(words_vhd=USE + """package words is
function word(n : std_logic) return std_logic;
end words;
package body words is
function word(n : std_logic) return std_logic is
begin
return gone;
end word;
end words;
""", top_vhd=USE + """use work.words.all;
entity top is port (SW : in std_logic_vector(9 downto 0); LEDR : out std_logic_vector(9 downto 0));
end top;
architecture a of top is
begin
LEDR <= (0 => word(SW(0)), others => '0');
end a;
""")
        self.refused('words.vhd:8:8: no declaration for "gone"')

    def test_vhdl_that_nobody_needs(self):
        self.write(p_qsf=QSF.replace("lab", "top") +
                   "set_global_assignment -name VHDL_FILE a.vhd\n", a_vhd="entity broken ( is\n",
                   top_v=LEDS.format("SW"))
        self.leds(3, 3)


if __name__ == "__main__":
    run()
