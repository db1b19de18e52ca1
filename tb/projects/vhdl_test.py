"""vhdl_test.py DE1SIM FOLDER [CASE...] - projects with VHDL, by GHDL."""
import os
import subprocess

from case import DE1SIM, LEDS, Case, run

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

    def test_a_folder_and_pins_that_are_not_driven(self):
        self.write(a_vhd=TOP.format("", "", "GPIO_0(3) <= SW(3) when SW(0) = '1' else 'Z';\n"
                                    "LEDR <= GPIO_0(9 downto 0);"))
        self.assertIn("the top module is taken to be Lab", self.leds(0x3FF))
        self.leds(0x3F7, 1)

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
        self.assertEqual(done.stderr, "de1sim: the project has VHDL, for which ghdl is not "
                                      "installed: apt install ghdl\n")

    def test_vhdl_that_nobody_needs(self):
        self.write(p_qsf=QSF.replace("lab", "top") +
                   "set_global_assignment -name VHDL_FILE a.vhd\n", a_vhd="entity broken ( is\n",
                   top_v=LEDS.format("SW"))
        self.leds(3, 3)


if __name__ == "__main__":
    run()
