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


if __name__ == "__main__":
    run()
