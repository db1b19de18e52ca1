"""init_files_test.py DE1SIM FOLDER [CASE...] - what memories begin with, from wherever it lies."""
from case import Case, run

MIF = "WIDTH=8; DEPTH=4; ADDRESS_RADIX=DEC; DATA_RADIX=HEX;\nCONTENT BEGIN {} END;\n"
HEAD = "module top(input CLOCK_50, input [9:0] SW, output [9:0] LEDR); assign LEDR[9:8] = 0;\n"
READS = ("reg [7:0] q; always @(posedge CLOCK_50) q <= m[SW[1:0]];\n"
         "assign LEDR[7:0] = q; endmodule\n")
ROM = HEAD + ("altsyncram r (.address_a(SW[1:0]), .clock0(CLOCK_50), .q_a(LEDR[7:0]));\n"
              'defparam r.operation_mode = "ROM", r.width_a = 8, r.widthad_a = 2,\n'
              '  r.numwords_a = 4, r.init_file = "{}"; endmodule\n')


class Attributes(Case):
    def attribute(self, declaration):
        self.write(top_v=HEAD + declaration + READS, words_mif=MIF.format("0: 11; 1: a5; 2: 3c;"))
        self.leds(0x3C, 2)
        self.write(words_mif=MIF.format("0: 11; 1: a5; 2: 77;"))
        self.assertNotIn("translating", self.leds(0x77, 2))
        self.checked("words.mif (top.v:2): words.mif")

    def test_in_parentheses(self):
        self.attribute('(* ramstyle = "M10K", ram_init_file = "words.mif" *) reg [7:0] m [0:3];\n')

    def test_in_a_comment(self):
        self.attribute('reg [7:0] m [3:0] /* synthesis ram_init_file = "words.mif" */;\n')

    def test_in_a_comment_to_the_lines_end(self):
        self.attribute('reg [7:0] m [0:3] // synthesis ram_init_file = "words.mif"\n;\n')

    def test_of_more_words_than_a_loop_may_have(self):
        self.write(words_mif="WIDTH=8; DEPTH=8192; CONTENT BEGIN 8191: 3c; END;\n"
                             .replace("CONTENT", "ADDRESS_RADIX=DEC; DATA_RADIX=HEX; CONTENT"),
                   top_v=HEAD + '(* ram_init_file = "words.mif" *) reg [7:0] m [0:8191];\n' +
                   READS.replace("SW[1:0]", "{13{SW[0]}}"))
        self.leds(0x3C, 1)


class Mifs(Case):
    def test_of_one_line_with_comments_everywhere(self):
        self.write(top_v=ROM.format("x.mif"), x_mif="Width=8;%a\n;b%DEPTH=4;--DEPTH=5;\n"
                   "address_radix=UNS;DATA_RADIX=bin;CONTENT--\nBegin--1\n"
                   "[0..1]:1010 0101;2:%3:1;%00111100;--2:0;\n3:11--\n;END;--x\n")
        self.leds(0b101, 1)
        self.leds(0x3C, 2)
        self.leds(3, 3)


class Places(Case):
    def test_beside_the_source(self):
        words = 'reg [7:0] m [0:3]; initial $readmemh("w/x.hex", m);\n'
        self.write(p_qsf="set_global_assignment -name TOP_LEVEL_ENTITY top\n"
                         "set_global_assignment -name VERILOG_FILE src/top.v\n",
                   src__top_v=HEAD + words + READS,
                   src__w__x_hex="01 02 a5 04\n")
        self.leds(0xA5, 2)
        self.checked("w/x.hex (src/top.v:2): src/w/x.hex")

    def test_of_another_machine_and_in_another_case(self):
        self.write(top_v=ROM.format("C:/me/lab/Font.MIF"), data__font_mif=MIF.format("[0..3]: 5a;"))
        self.leds(0x5A, 1)
        self.checked("C:/me/lab/Font.MIF (top.v:2): data/font.mif")

    def test_words_beyond_the_array(self):
        self.write(top_v=HEAD + 'reg [7:0] m [0:3]; initial $readmemh("x.hex", m);\n' + READS,
                   x_hex="01 02 a5 04\n05 06\n")
        self.assertIn("10850: the file has more words than the array", self.leds(0xA5, 2))

    def test_nowhere(self):
        self.write(top_v=ROM.format("gone.mif"))
        self.assertIn("gone.mif: not found", self.leds(0, 1))
        self.checked("gone.mif (top.v:2): not found, the memory will begin with zeros")


class Broken(Case):
    """Files that Quartus refuses, and de1sim before the design runs."""

    def test_words_for_readmemh_as_a_memorys_file(self):
        self.write(top_v=ROM.format("data/x.hex"), data__x_hex="// of the ROM\n01 02\na5 04\n")
        message = ('data/x.hex:2: "01 02" are words for $readmemh, expected Intel HEX, whose lines '
                   "begin with a colon, or a MIF, as the initial words of the memory at top.v:2")
        self.refused(message)
        self.refused(message, "build", ".")

    def test_a_mif(self):
        for design in (ROM.format("words.mif"),
                       HEAD + '(* ram_init_file = "words.mif" *) reg [7:0] m [0:3];\n' + READS):
            self.write(top_v=design, words_mif=MIF.format("0: 11;\n1: 5g;"))
            self.refused('words.mif:3: "5G", expected a value in base 16, as the initial words of '
                         "the memory at top.v:2")

    def test_words_for_readmemh_that_are_none(self):
        self.write(top_v=HEAD + 'reg [7:0] m [0:3]; initial $readmemh("x.hex", m);\n' + READS,
                   x_hex="/* words\n */ 01 // of it\n@2 a_5 :02\n")
        self.refused('x.hex:3: ":02", expected hexadecimal digits of a word, or @ and an address')

    def test_words_that_are_right_in_all_ways_of_writing(self):
        self.write(top_v=HEAD + 'reg [7:0] m [0:3]; initial $readmemb("x.txt", m);\n' + READS,
                   x_txt="/* 2 */ 1_0 // 9\n01/**/x1\t@3\r\n11")
        self.leds(3, 3)

    def test_of_a_module_that_the_design_does_not_have_are_not_read(self):
        self.write(top_v=HEAD + "assign LEDR[7:0] = SW[7:0]; endmodule\nmodule other;\n"
                   'reg [7:0] m [0:3]; initial $readmemh("x.hex", m); endmodule\n', x_hex="ghi\n")
        self.checked("top module: top")

    def test_of_a_parameter_in_the_projects_own_module(self):
        """It has the name that a model's has, and is no MIF."""
        self.write(top_v=HEAD + "rom #(.INIT_FILE(\"x.hex\")) r (CLOCK_50, SW[1:0], LEDR[7:0]);\n"
                   "endmodule\nmodule rom #(parameter INIT_FILE = \"\") (input c, input [1:0] a,\n"
                   "output reg [7:0] q); reg [7:0] m [0:3]; initial $readmemh(INIT_FILE, m);\n"
                   "always @(posedge c) q <= m[a]; endmodule\n", x_hex="01 02 a5 04\n")
        self.leds(0xA5, 2)


if __name__ == "__main__":
    run()
