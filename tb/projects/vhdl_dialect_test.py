"""vhdl_dialect_test.py DE1SIM FOLDER [CASE...] - VHDL that Quartus takes and GHDL does not."""
from case import Case, run

USE = "library ieee; use ieee.std_logic_1164.all; use ieee.numeric_std.all;\n"
TOP = USE + """entity top is port (
  CLOCK_50 : in std_logic; SW : in std_logic_vector(9 downto 0);
  LEDR : out std_logic_vector(9 downto 0)); end;
architecture a of top is
{}
begin
{}
end;
"""
PART = USE + """entity part is generic (n : integer := 8; g : std_logic_vector(1 downto 0) := "10");
port (v : in std_logic_vector(3 downto 0); s : in std_logic_vector(1 downto 0);
  q : out std_logic_vector(9 downto 0)); end;
architecture x of part is
  constant k : integer := n / 4;
  subtype small is integer range 0 to k;
  type states is (idle, go, stop, halt);
  constant first : states := states'val(n / 8);
  signal state : states;
  signal c : integer range 0 to 15;
begin
  c <= to_integer(unsigned(v));
  state <= states'val(to_integer(unsigned(s)));
{}
end;
"""
CHOICES = """  process (c, s, state) begin
    q(5 downto 0) <= "000000";
    -- case c is when k => nothing
    outer : CASE c is  -- "when", and a range
      when 0 to k - 1 | 15 => -- case
        q(0) <= '1';
        case s is when g => q(1) <= '1'; when "00" | "01" => null;
          when others => q(1) <= '0'; end case;
      when k
        | /* n */ k + 1 =>
        q(2) <= '1';
      when 14 downto n => q(3) <= '1' after 1 ns; when OTHERS => null;
    end case outer;
    case state is when first => q(5 downto 4) <= "01";
      when stop to states'right => q(5 downto 4) <= "10";
      when idle => q(5 downto 4) <= "11"; end case;
  end process;
  with s select q(6) <= '1' when g, '0' when "00" | "01", '1' when others;
  with c select
    q(7) <= '1' when small'high,
            '0' when others;
  process (c) begin case c is when natural range 1 to k => q(9 downto 8) <= "01";
    when integer range 5 downto n => q(9 downto 8) <= "11";
    when others => q(9 downto 8) <= "00"; end case; end process;"""
INSTANCE = ("p : entity work.part generic map (n => 12)\n"
            "  port map (SW(3 downto 0), SW(5 downto 4), LEDR);")


def chosen(switches):
    """What CHOICES gives with n = 12."""
    c, s, leds = switches & 15, switches >> 4, 0
    if c < 3 or c == 15:
        leds = 1 | 2 * (s == 2)
    elif c in (3, 4):
        leds = 4
    elif c >= 12:
        leds = 8
    return leds | (3, 1, 2, 2)[s] << 4 | (s >= 2) << 6 | (c == 3) << 7 | (1 <= c <= 3) << 8


class Choices(Case):
    """Of a case statement and a selected assignment, which come from a generic."""

    def test_are_taken(self):
        self.write(top_vhd=TOP.format("", INSTANCE), part_vhd=PART.format(CHOICES))
        steps, before = [], 0
        for switches in range(64):
            for word, to, other in (("hold", switches, before), ("release", before, switches)):
                moved = [i for i in range(6) if to >> i & 1 and not other >> i & 1]
                steps += [f"{word}: {{switch: {moved}}}"] if moved else []
            steps += ["delay: 20ms", f'expect-leds: "{chosen(switches):010b}"']
            before = switches
        self.plays(*steps)

    def test_of_all_bits_without_others(self):
        self.write(top_vhd=TOP.format(
            "", "process (SW) begin case SW(2 downto 1) is when \"00\" | \"11\" => LEDR <= SW;\n"
                "when \"01\" => LEDR <= (others => '0'); when \"10\" => LEDR <= (others => '1');\n"
                "end case; end process;"))
        self.leds(0b111, 0b111)
        self.leds(0, 0b010)
        self.leds(0b1111111111, 0b100)

    def test_of_fewer_than_all_bits_are_refused(self):
        self.write(top_vhd=TOP.format(
            "", "process (SW) begin case SW(2 downto 1) is when \"00\" | \"11\" => LEDR <= SW;\n"
                "when \"01\" => LEDR <= (others => '0'); end case; end process;"))
        self.refused("top.vhd:8:")

    def part(self, body):
        self.write(top_vhd=TOP.format("", INSTANCE), part_vhd=PART.format(body))

    def test_of_an_attribute_and_of_a_process_with_a_clock(self):
        self.write(top_vhd=TOP.format(
            "", "p : entity work.part generic map (n => 2) port map (CLOCK_50, SW, LEDR);"),
            part_vhd=USE + "entity part is generic (n : integer); port (c : in std_logic;\n"
            "v : in std_logic_vector(9 downto 0); q : out std_logic_vector(9 downto 0)); end;\n"
            "architecture a of part is signal x : std_logic_vector(n + 1 downto n);\n"
            "signal i : integer range 0 to 7; begin i <= to_integer(unsigned(v(2 downto 0)));\n"
            "x <= \"00\"; process (c) begin if rising_edge(c) then case i is\n"
            "when x'range => q <= \"0000000001\"; when x'reverse_range(1) => q <= v;\n"
            "when others => q <= \"1000000000\"; end case; end if; end process; end;\n")
        self.leds(1, 3)
        self.leds(512, 4)

    def test_an_error_beside_them_has_its_own_line(self):
        self.part("  process (c) begin\n    case c is\n      when k => q <= (others => '0');\n"
                  "      when others => q <= gone;\n    end case;\n  end process;\n")
        self.refused('part.vhd:18: no declaration for "gone"')

    def test_that_cannot_be_written_as_conditions_are_refused_as_they_are(self):
        for body, place in (
                ("  process (c) begin case c is when small => q <= (others => '0');\n"
                 "    when others => q <= (others => '1'); end case; end process;", "part.vhd:15:"),
                ("  process (s) begin case s is\n    when g => q <= (others => '0');\n"
                 "    when \"1Z\" => null; when others => q <= (others => '1'); end case;\n"
                 "  end process;", "part.vhd:16:")):
            self.part(body)
            said = self.de1sim("check", ".")
            self.assertEqual(said.returncode, 2)
            self.assertRegex(said.stderr, f"\nde1sim: {place}.*: choice .*locally static")


class Dialect(Case):
    def test_words_of_vhdl_2008_are_names(self):
        """Of an entity's ports and generics, too, with Verilog around it."""
        self.write(top_v="module top(input CLOCK_50, input [9:0] SW, output [9:0] LEDR);\n"
                         "part #(.property(3)) u (.Release(SW[0]), .\\force (LEDR[4:1]));\n"
                         "assign LEDR[9:5] = 0; assign LEDR[0] = SW[1]; endmodule\n",
                   part_vhd=USE + "entity part is generic (Property : integer := 2);\n"
                   "port (Release : in std_logic; force : out std_logic_vector(3 downto 0)); end;\n"
                   "architecture a of part is signal sequence, default, strong : std_logic;\n"
                   "function cover(parameter : std_logic) return std_logic is\n"
                   "begin return not PARAMETER; end; begin\n"
                   "sequence <= cover(release); default <= sequence; strong <= default;\n"
                   "force <= strong & std_logic_vector(to_unsigned(property, 3)); end;\n")
        self.leds(0b10110, 0)
        self.leds(0b00110, 1)

    def test_an_error_has_the_names_that_the_text_has(self):
        self.write(top_vhd=TOP.format("signal release : std_logic;", "LEDR <= release;"))
        done = self.de1sim("check", ".")
        self.assertEqual(done.returncode, 2)
        self.assertIn("de1sim: top.vhd:8:", done.stderr)
        self.assertNotIn("de1sim93", done.stderr)

    def test_directives_of_all_names(self):
        self.write(top_vhd=TOP.format(
            "", "-- altera translate_off\nLEDR <= gone; -- it's \"open\n-- altera translate_on\n"
                "-- exemplar translate_off\nLEDR <= gone;\n-- exemplar translate_on\n"
                "--pragma synthesis_off\nLEDR <= gone;\n--pragma synthesis_on\n"
                "-- synthesis read_comments_as_HDL on\n--  LEDR(9 downto 1) <= \"000000111\";\n"
                "-- synthesis read_comments_as_HDL off\n--  LEDR(9 downto 1) <= gone;\n"
                "LEDR(0) <= SW(0);"))
        self.leds(0b1111, 1)

    def test_a_wait_for_a_level_is_a_clock(self):
        self.write(top_vhd=TOP.format(
            "signal n : unsigned(3 downto 0) := \"0000\"; signal m : std_logic := '0';",
            "process begin wait until (CLOCK_50 = '1'); if n /= 9 then n <= n + 1; end if;\n"
            "end process; process begin wait\n  UNTIL clock_50 = '0'; m <= '1'; end process;\n"
            "LEDR <= \"00000\" & m & std_logic_vector(n);"))
        self.leds(0b11001)


class Memories(Case):
    """By the attribute ram_init_file."""
    MIF = ("WIDTH=8; DEPTH=4; ADDRESS_RADIX=DEC; DATA_RADIX=HEX;\n"
           "CONTENT BEGIN 0: 11; 1: a5; 2: 3c; END;\n")

    def memory(self, word, file, declared="array (0 to 3)", reads="m(a)"):
        self.write(top_vhd=TOP.format(
            f"constant FILE_NAME : string := \"words.mif\"; {word}\n"
            f"type words is {declared} of word; signal a : integer range 0 to 3;\n"
            "Signal M : words; signal q : std_logic_vector(7 downto 0);\n"
            "attribute ram_init_file : string;\n"
            f"attribute RAM_INIT_FILE of m : signal is {file};",
            "a <= to_integer(unsigned(SW(1 downto 0))); LEDR <= \"00\" & q;\n"
            f"process (CLOCK_50) begin if rising_edge(CLOCK_50) then q <= {reads};\n"
            "if SW(9) = '1' then m(a) <= SW(9 downto 2); end if; end if; end process;"))

    def test_of_a_mif(self):
        self.memory("subtype word is std_logic_vector(7 downto 0);", '"data/words.mif"')
        self.write(data__words_mif=self.MIF)
        self.checked("data/words.mif (top.vhd:10): data/words.mif")
        self.leds(0x3C, 2)
        self.leds(0xA0, 0b1010000001, wait="20ms")

    def test_of_a_mif_by_a_constant_and_of_words_as_wide_as_a_constant_says(self):
        self.memory("constant W : integer := 8; subtype word is std_logic_vector(W-1 downto 0);",
                    "FILE_NAME", "array (3 downto 0)")
        self.write(words_mif=self.MIF)
        self.leds(0xA5, 1)

    def test_of_intel_hex(self):
        self.memory("subtype word is unsigned(7 downto 0);", '"x.hex"',
                    reads="std_logic_vector(m(a))")
        text = (self.folder / "top.vhd").read_text()
        self.write(top_vhd=text.replace("<= SW(9 downto 2)", "<= unsigned(SW(9 downto 2))"),
                   x_hex=":0400000011A53C00" "0A\n:00000001FF\n")
        self.leds(0x3C, 2)

    def test_of_a_broken_file(self):
        self.memory("subtype word is std_logic_vector(7 downto 0);", '"words.mif"')
        self.write(words_mif=self.MIF.replace("3c", "3x"))
        self.refused('words.mif:2: "3X", expected a value in base 16, as the initial words of the '
                     "memory at top.vhd:10")


class Libraries(Case):
    def test_of_intels_packages(self):
        """Each with a component that only it has."""
        self.write(top_vhd="library altera, altera_lnsim, altera_mf, cyclonev;\n"
                   "use altera.maxplus2.all; use altera.altera_syn_attributes.all;\n"
                   "use altera_lnsim.altera_lnsim_components.all;\n"
                   "use altera_mf.altera_mf_components.all;\n"
                   "use cyclonev.cyclonev_components.all;\n" + TOP.format(
                       "signal d, p, g : std_logic_vector(7 downto 0);\n"
                       "signal s : std_logic_vector(2 downto 0);\n"
                       "attribute keep of d : signal is true;\n"
                       'attribute ramstyle of a : architecture is "M10K";',
                       "d <= SW(7 downto 0);\n"
                       "m : altera_syncram generic map (operation_mode => \"ROM\", width_a => 8,\n"
                       "    widthad_a => 2, numwords_a => 4, init_file => \"words.mif\")\n"
                       "  port map (clock0 => CLOCK_50, address_a => SW(1 downto 0), q_a => p);\n"
                       "o : altsource_probe generic map (source_width => 3, probe_width => 8,\n"
                       "    source_initial_value => \"5\") port map (probe => d, source => s);\n"
                       "c : lcell port map (d(2), LEDR(9)); LEDR(8) <= g(0);\n"
                       "h : cyclonev_hps_interface_dbg_apb port map (dbg_apb_disable => SW(0));\n"
                       "LEDR(7 downto 0) <= p(7 downto 3) & s; g <= d;"),
                   words_mif="WIDTH=8; DEPTH=4; ADDRESS_RADIX=DEC; DATA_RADIX=HEX;\n"
                             "CONTENT BEGIN 0: 11; 1: a8; 2: 38; END;\n")
        self.leds(0b0000111101, 2)
        self.leds(0b1110101101, 5)


if __name__ == "__main__":
    run()
