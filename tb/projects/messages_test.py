"""messages_test.py DE1SIM FOLDER README - what Quartus warns of and refuses, a project for each.

README has a table of the numbers; each of them is here.
"""
import pathlib
import re
import sys

from case import GHDL, Case, run

README = pathlib.Path(sys.argv.pop(3)).read_text()
HEAD = "module top(input CLOCK_50, input [3:0] KEY, input [9:0] SW, output {} [9:0] LEDR);\n"
ALL = "assign LEDR = SW ^ {CLOCK_50, KEY};\n"
REG, WIRE, END = HEAD.format("reg"), HEAD.format("wire"), "endmodule\n"
SUB = "module sub(input [1:0] a, b, output [3:0] q); assign q = a + b; endmodule\n"
VHDL = ("library ieee; use ieee.std_logic_1164.all;\n"
        "entity top is port (CLOCK_50 : in std_logic; KEY : in std_logic_vector(3 downto 0);\n"
        "SW : in std_logic_vector(9 downto 0); LEDR : out std_logic_vector(9 downto 0)); end;\n"
        "architecture a of top is signal n : std_logic_vector(9 downto 0);\nbegin\n")
VHDL_END = "LEDR <= n;\nend;\n"
QSF = "set_global_assignment -name VERILOG_FILE top.v\n"

# The text of top.v, or of the files; and what is said.
WARNINGS = {
    10027: (WIRE + "reg [3:0] m [0:15]; initial m[0] = 1;\nassign LEDR = m[SW[1:0]];\n" + END,
            "top.v:3: 10027: an index of 2 bits does not reach all words"),
    10030: (WIRE + "wire [3:0] w;\nassign w[1:0] = SW[1:0];\nassign LEDR = w;\n" + END,
            "top.v:2: 10030: w[3:2] has no driver"),
    10034: (WIRE + "assign LEDR[3:0] = SW[3:0];\n" + END,
            "top.v:1: 10034: output LEDR[9:4] has no driver"),
    10036: (WIRE + ALL + "reg [3:0] n;\nalways @(posedge CLOCK_50) n <= SW[3:0];\n" + END,
            "top.v:3: 10036: n is assigned, but never read"),
    10037: (WIRE + "assign LEDR = SW >= 0 ? 10'd1 : SW;\n" + END,
            "top.v:2: 10037: the comparison always has the same result"),
    10175: (WIRE + ALL + "initial $monitor(\"%b\", LEDR);\n" + END,
            "top.v:3: 10175: $monitor does nothing on the board"),
    10199: (REG +
            "always @(*)\ncase (SW[1:0])\n  3'd4: LEDR = 1;\n  default: LEDR = 2;\nendcase\n" +
            END, "top.v:4: 10199: this item of the case can never be met"),
    10222: ("module top #(parameter W = 1) (input [9:0] SW, output [9:0] LEDR);\n"
            "parameter K = 10'd3;\nassign LEDR = SW + K;\n" + END,
            "top.v:2: 10222: the module has a list of parameters in its head"),
    10229: (WIRE + "assign LEDR = SW ^ 4'b110101;\n" + END, "top.v:2: 10229: 4'b110101 has more"),
    10230: (REG + "always @(posedge CLOCK_50)\n  LEDR <= LEDR + 1;\n" + END,
            "top.v:3: 10230: a value of 32 bits, for a number in it has no size, is cut to 10"),
    10235: (REG + "always @(SW[0])\n  LEDR = SW[0] & KEY[0];\n" + END,
            "top.v:2: 10235: KEY is read in the block, but is not in its list"),
    10236: (WIRE + "sub s(.a(SW[1:0]), .b(SW[3:2]), .q(conut));\n" + ALL +
            END + SUB, "top.v:2: 10236: conut is not declared"),
    10240: (REG + "always @(*)\n  if (KEY[0]) LEDR = SW;\n" + END,
            "top.v:2: 10240: LEDR keeps its value on some paths"),
    10259: (WIRE + "assign LEDR = SW ^ 4'd20;\n" + END, "top.v:2: 10259: 4'd20 does not fit"),
    10268: (REG + "reg [9:0] n;\nalways @(posedge CLOCK_50) begin\n  n = SW;\n  LEDR <= n;\nend\n" +
            END, "top.v:4: 10268: the block has both = and <="),
    10270: (REG + "always @(posedge CLOCK_50)\ncase (SW[1:0])\n  0: LEDR <= 1;\n  1: LEDR <= 2;\n"
            "endcase\n" + END, "top.v:3: 10270: the case is not complete, and has no default"),
    10272: (REG + "always @(*)\ncase (SW[1:0])\n  2'd1: LEDR = 1;\n  2'd1: LEDR = 2;\n"
            "  default: LEDR = 3;\nendcase\n" + END,
            "top.v:5: 10272: this item of the case (1) was there before"),
    10273: (WIRE + "wire [7:0] w = 8'bx;\nassign LEDR = SW ^ w;\n" + END,
            "top.v:2: 10273: 8'bx is extended with x"),
    10281: (WIRE + "wire Sw = SW[0];\nassign LEDR = Sw;\n" + END,
            "top.v:2: 10281: Sw and SW differ in their case alone"),
    10463: (WIRE + "wire final = SW[0];\nassign LEDR = final;\n" + END,
            'top.v:2: 10463: "final" is a word of SystemVerilog'),
    10644: (REG + "always @(posedge CLOCK_50) begin integer k; k = SW; LEDR <= k; end\n" + END,
            "top.v:2: 10644: a block with a declaration (integer) needs a name"),
    10762: (REG + "reg [31:0] n;\nalways @(posedge CLOCK_50) n <= n + 32'd1;\nalways @(*)\n"
            "casez (n)\n  32'h1???????: LEDR = 1;\n  default: LEDR = 2;\nendcase\n" + END,
            "top.v:5: 10762: the case has too many values"),
    10846: (WIRE + "sub (SW[1:0], SW[3:2], LEDR[3:0]);\n" + END + SUB,
            "top.v:2: 10846: the instance of sub has no name"),
    10858: (WIRE + "wire [9:0] count;\nassign LEDR = SW ^ count;\n" + END,
            "top.v:2: 10858: count is used, but nothing drives it"),
    12010: (WIRE + "sub s(.a(SW[1:0]), .b(SW), .q(LEDR[3:0]));\nassign LEDR[9:4] = SW[9:4];\n" +
            END +
            SUB, "top.v:2: 12010: port b has 2 bits and is connected with 10"),
    12019: ({"p.qsf": QSF + "set_global_assignment -name VERILOG_FILE gone.v\n"
             "set_global_assignment -name TOP_LEVEL_ENTITY top\n", "top.v": WIRE + ALL + END},
            "p.qsf:2: 12019: gone.v is not there"),
    12020: (WIRE + "sub s(.a(SW[0]), .b(SW[2:1]), .q(LEDR[3:0]));\nassign LEDR[9:4] = 0;\n" + END +
            SUB, "top.v:2: 12020: port a has 2 bits and is connected with 1"),
    12030: (WIRE + "sub s(.a(SW[1:0]), .b(SW[3:2]), .q(LEDR[0]));\nassign LEDR[9:1] = 0;\n" + END +
            SUB, "top.v:2: 12030: port q has 4 bits and is connected with 1"),
    12090: (WIRE + "wire q;\ndffe f(SW[0], q);\nassign LEDR = q;\n" + END +
            "module dffe(input a, output b); assign b = a; endmodule\n",
            "12090: module dffe is that of top.v"),
    12125: ({"p.qsf": QSF + "set_global_assignment -name TOP_LEVEL_ENTITY top\n",
             "top.v": WIRE + "sub s(SW[1:0], SW[3:2], LEDR[3:0]);\n" + END, "sub.v": SUB},
            "12125: sub.v is not listed; it defines sub"),
    12241: (WIRE + "sub s(.a(SW[1:0]), .q(LEDR[3:0]));\nassign LEDR[9:4] = SW[9:4];\n" + END + SUB,
            "top.v:2: 12241: instance s of sub: not connected, so 0: b"),
    13040: ("module top(input [9:0] SW, output [9:0] LEDR, inout [35:0] GPIO_0);\n"
            "assign LEDR = SW ^ GPIO_0[9:0];\n" +
            END, "top.v:1: 13040: inout GPIO_0 is never driven"),
    13049: (WIRE + "wire b = SW[0] ? SW[1] : 1'bz;\nassign LEDR = b & SW;\n" + END,
            "top.v:2: 13049: b is released inside the chip"),
    13410: (WIRE.replace(");", ", output [6:0] HEX0);") + ALL + "assign HEX0 = 7'h7f;\n" + END,
            "top.v:3: 13410: output HEX0 is constant"),
    15610: (WIRE + "assign LEDR = SW ^ CLOCK_50;\n" + END, "top.v:1: 15610: input KEY is not used"),
    15706: ({"p.qsf": QSF + "set_global_assignment -name TOP_LEVEL_ENTITY top\n"
             "set_location_assignment PIN_AA14 -to KEY[0]\n"
             "set_location_assignment PIN_AE26 -to HEX0[0]\n", "top.v": WIRE + ALL + END},
            "p.qsf:1: 15706: 1 pins are assigned to what the top has not"),
    125092: ({"p.qsf": QSF + "set_global_assignment -name QIP_FILE pll.qip\n"
              "set_global_assignment -name TOP_LEVEL_ENTITY top\n", "top.v": WIRE + ALL + END},
             "p.qsf:2: 125092: pll.qip is not there"),
    169085: ({"p.qsf": QSF + "set_global_assignment -name TOP_LEVEL_ENTITY top\n"
              "set_location_assignment PIN_AA14 -to KEY[0]\n", "top.v": WIRE + ALL + END},
             "p.qsf:1: 169085: 24 of the top's ports have no pin"),
    170048: (REG + "reg [23:0] m [0:307199]; reg [18:0] a;\n"
             "always @(posedge CLOCK_50) begin a <= a + 19'd1; m[a] <= SW; LEDR <= m[a]; end\n" +
             END, "top.v:2: 170048: the design's memories have 7372800 bits"),
    171016: ({"p.qsf": QSF + "set_global_assignment -name TOP_LEVEL_ENTITY top\n"
              "set_location_assignment PIN_A4 -to SW[1]\n", "top.v": WIRE + ALL + END},
             "p.qsf:3: 171016: sw[1] is assigned to PIN_A4, where the board has nothing"),
    332012: ({"p.qsf": QSF + "set_global_assignment -name SDC_FILE top.sdc\n"
              "set_global_assignment -name TOP_LEVEL_ENTITY top\n", "top.v": WIRE + ALL + END},
             "p.qsf:2: 332012: top.sdc is not there"),
    332060: (REG + "reg [3:0] slow;\nalways @(posedge CLOCK_50) slow <= slow + 4'd1;\n"
             "always @(posedge slow[3]) LEDR <= SW;\n" + END,
             "top.v:2: 332060: slow is a register and a clock"),
}
ERRORS = {
    10028: (REG + "always @(posedge CLOCK_50) if (!KEY[0]) LEDR <= 1;\n"
            "always @(posedge CLOCK_50) if (!KEY[1]) LEDR <= 2;\n" + END,
            "top.v:3: Quartus error 10028: LEDR has two drivers, here by an always block and at "
            "top.v:2 by an always block (10029)"),
    10054: (WIRE + ALL + '`include "gone.vh"\n' + END,
            "top.v:3: Quartus error 10054: the file gone.vh that is included is not there"),
    10106: (REG + "parameter N = 5001; integer i;\nalways @(*) begin LEDR = 0;\n"
            "for (i = 0; i < N; i = i + 1) LEDR = LEDR + SW; end\n" + END,
            "top.v:4: Quartus error 10106: the loop has more than 5000 rounds"),
    10119: (REG + "reg [9:0] n;\nalways @(*) begin n = SW; LEDR = 1;\n"
            "while (n != 0) begin LEDR = LEDR << 1; n = n - 1; end end\n" + END,
            "top.v:4: Quartus error 10119: how many rounds the loop has depends on a signal"),
    10122: (REG + "always @(posedge CLOCK_50 or KEY) LEDR <= SW;\n" + END,
            "top.v:2: Quartus error 10122: the list has signals with an edge beside"),
    10137: (WIRE + "always @(*) LEDR = SW;\n" + END,
            "top.v:2: Quartus error 10137: LEDR is a wire, and is assigned in a block"),
    10149: (WIRE + ALL + "reg [9:0] LEDR;\n" + END,
            "top.v:3: Quartus error 10149: LEDR is declared in the module's head"),
    10161: (WIRE + "wire count;\nassign LEDR = SW ^ cuont;\n" + END,
            "top.v:3: Quartus error 10161: cuont is not declared; is it count?"),
    10170: (WIRE + "assign LEDR = SW\nassign x = 1;\n" + END,
            'top.v:3: Quartus error 10170: syntax error near "assign"'),
    10172: (REG + "real volts;\nalways @(*) begin volts = SW * 0.5; LEDR = volts; end\n" + END,
            "top.v:2: Quartus error 10172: real variables are for simulation alone"),
    10174: (REG + "always @(posedge KEY[0]) LEDR <= $random % 6;\n" + END,
            "top.v:2: Quartus error 10174: $random is for simulation alone"),
    10200: (REG + "wire r = SW[0];\nalways @(posedge CLOCK_50 or negedge r)\nif (KEY[0]) LEDR <= 0;"
            " else LEDR <= SW;\n" +
            END, "top.v:4: Quartus error 10200: the list has several edges"),
    10207: (WIRE + "wire [3:0] q;\nsub s(SW[1:0], SW[3:2], q);\nassign LEDR = s.a;\n" + END +
            SUB, "top.v:4: Quartus error 10207: s.a is inside the instance s"),
    10219: (REG + "assign LEDR = SW;\n" + END,
            "top.v:2: Quartus error 10219: LEDR is a reg, and is assigned by `assign`"),
    10228: ({"p.qsf": QSF + "set_global_assignment -name VERILOG_FILE old.v\n",
             "top.v": WIRE + ALL + END, "old.v": WIRE + END},
            "old.v:1: Quartus error 10228: module top is declared at top.v:1, too"),
    10231: (WIRE + ALL + "assign SW[0] = 1;\n" + END,
            "top.v:3: Quartus error 10231: input SW is assigned"),
    10232: (WIRE + "assign LEDR = {9'd0, SW[10]};\n" + END,
            "top.v:2: Quartus error 10232: 10 is an index outside of the range [9:0]"),
    10239: (REG + "always @(posedge CLOCK_50 or negedge CLOCK_50) LEDR <= SW;\n" + END,
            "top.v:2: Quartus error 10239: the list has both edges of CLOCK_50"),
    10278: (WIRE + ALL + END + "module sub(input reg a, output b); assign b = a; endmodule\n",
            "top.v:4: Quartus error 10278: an input cannot be a reg"),
    10355: ({"top.sv": WIRE + "typedef enum logic [1:0] {A = 1, B = 2} states;\nstates s;\n"
             "assign s = B, LEDR = s;\n" + END},
            "top.sv:2: Quartus error 10355: the value of A has no size, so it has 32 bits"),
    10644: (WIRE + "genvar g;\ngenerate for (g = 0; g < 10; g = g + 1) begin\n"
            "assign LEDR[g] = SW[9 - g];\nend endgenerate\n" + END,
            "top.v:3: Quartus error 10644: the block of a generate loop needs a name"),
    10663: (WIRE + "reg [3:0] q;\nsub s(SW[1:0], SW[3:2], q);\nassign LEDR = q;\n" + END + SUB,
            "top.v:3: Quartus error 10663: q is a reg, and is connected with the output q"),
    10773: (WIRE + ALL + END + "module sub(input [3:0] a [0:1], output b); endmodule\n",
            "top.v:4: Quartus error 10773: port a is an array"),
    10820: ({"top.vhd": VHDL + "process (CLOCK_50) begin if rising_edge(CLOCK_50) then n <= SW; "
             "elsif falling_edge(CLOCK_50) then n <= not SW; end if; end process;\n" + VHDL_END},
            "top.vhd:6: Quartus error 10820: the register has more than one clock"),
    12002: (WIRE + "sub s(.c(SW[0]), .q(LEDR[3:0]));\n" + END + SUB,
            "top.v:2: Quartus error 12002: the module that is instanced has no port c"),
    12007: ({"p.qsf": QSF + "set_global_assignment -name TOP_LEVEL_ENTITY main\n",
             "top.v": WIRE + ALL + END},
            "p.qsf:2: Quartus error 12007: no file defines the top-level entity main; the files "
            "define top"),
    12006: (WIRE + ALL + "gone g(SW[0]);\n" + END,
            "top.v:3: Quartus error 12006: no file defines module gone"),
    12014: (WIRE + "sub a(SW[1:0], SW[3:2], LEDR[3:0]);\nsub b(SW[1:0], SW[3:2], LEDR[4:1]);\n" +
            END + SUB, "top.v:3: Quartus error 12014: LEDR[3:1] has two drivers, here by q of "
            "instance b and at top.v:2 by q of instance a (12015)"),
    13076: (WIRE + "wire b;\nassign b = SW[0] ? SW[1] : 1'bz;\nassign b = SW[2];\n"
            "assign LEDR = b;\n" +
            END, "top.v:3: Quartus error 13076: b has a tri-state buffer here"),
    276003: (REG + "reg [31:0] m [0:4095]; integer i;\n"
             "always @(posedge CLOCK_50 or negedge KEY[0])\n"
             "if (!KEY[0]) for (i = 0; i < 4096; i = i + 1) m[i] <= 0;\n"
             "else begin m[SW] <= SW; LEDR <= m[SW]; end\n" + END,
             "top.v:2: Quartus error 276003: m is cleared by a reset, which no memory can be"),
    171016: ({"p.qsf": QSF + "set_location_assignment PIN_AA2 -to SW[1]\n",
              "top.v": WIRE + ALL + END},
             "p.qsf:2: Quartus error 171016: sw[1] is assigned to PIN_AA2, which is no pin"),
    176310: ({"p.qsf": QSF + "set_location_assignment PIN_AB12 -to SW[0]\n"
              "set_location_assignment PIN_AB12 -to SW[1]\n", "top.v": WIRE + ALL + END},
             "p.qsf:3: Quartus error 176310: sw[0] and sw[1] are both on PIN_AB12"),
}
# What has no word of its own in Verilog-2001, or no place in hardware: of top.v, or of top.sv.
SYNTAX = [
    ("v", "always_ff @(posedge CLOCK_50) ;", 'near "always_ff"'),
    ("v", "logic x;", 'near "logic"'),
    ("v", "reg [1:0] n; always @(*) begin n = 0; n++; end", 'near "+"'),
    ("v", "reg [1:0] n; always @(*) begin n = 0; n += 1; end", 'near "+"'),
    ("v", "reg [3:0][7:0] n;", 'near "["'),
    ("v", "reg [7:0] n [4];", 'near "]"'),
    ("v", "wire [1:0] n = '0;", "near \"'\""),
    ("v", "sub s(.a, .b(SW[3:2]), .q());", 'near "."'),
    ("v", "reg n; always @(*) begin : name n = 0; end : name", 'near ":"'),
    ("v", "typedef reg [3:0] four;", 'near "typedef"'),
    ("v", "reg n; always @(*) for (int i = 0; i < 2; i = i + 1) n = i;", 'near "int"'),
    ("sv", "wire w = SW inside {1, 2};", 'near "inside"'),
    ("sv", "wire [9:0] w = {<<{SW}};", 'near "<"'),
    ("sv", "logic w;;", 'near ";"'),
    ("sv", "generate if (1) begin : g wire w; end endgenerate;", 'near ";"'),
    ("sv", "localparam type T = logic;", 'near "type"'),
    ("sv", "class c; endclass", "Quartus has no classes"),
    ("v", "reg n; always begin @(posedge CLOCK_50) n <= 1; end", "always needs a list of events"),
    ("v", "reg n; always @(posedge CLOCK_50) begin wait (KEY[0]); n <= 1; end", "wait cannot be"),
    ("v", "reg n; always @(*) begin n = 0; @(posedge CLOCK_50); end", "an event control inside"),
    ("v", "reg n; always @(*) fork n = 0; join", "fork cannot be built"),
]
# What looks like one of those, and is none: the bodies of modules, which Quartus takes.
TAKEN = {
    "two ports of a memory": "reg [9:0] m [0:7]; reg [9:0] q; assign LEDR = q;\n"
    "always @(posedge CLOCK_50) if (KEY[0]) m[SW[2:0]] <= SW;\n"
    "always @(posedge CLOCK_50) begin if (KEY[1]) m[SW[5:3]] <= 1; q <= m[SW[2:0]]; end\n",
    "a loop variable of two blocks": "reg [9:0] a; assign LEDR = a; integer i;\n"
    "always @(posedge CLOCK_50) for (i = 0; i < 5; i = i + 1) a[i] <= SW[i];\n"
    "always @(posedge CLOCK_50) for (i = 5; i < 10; i = i + 1) a[i] <= SW[i];\n",
    "two drivers with enables": "wire [9:0] b; assign b = SW[0] ? 10'd1 : 10'bz;\n"
    "assign b = SW[0] ? 10'bz : 10'd2; assign LEDR = b;\n",
    "drivers of other bits": "genvar g; generate for (g = 0; g < 5; g = g + 1) begin : s\n"
    "assign LEDR[2 * g] = SW[g]; sub u(SW[g], LEDR[2 * g + 1]); end endgenerate\n",
    "a default that is never reached": "reg [9:0] a, b; assign LEDR = a ^ b;\n"
    "always @(*) case (SW[0]) 0: a = 1; 1: a = 2; default: b = 0; endcase\n"
    "always @(*) b = SW;\n",
    "a variable that blocks use for themselves": "reg [9:0] t, a, b; assign LEDR = a ^ b;\n"
    "always @(*) begin t = SW + 10'd1; a = t; end\n"
    "always @(*) begin t = SW + 10'd2; b = t; end\n",
    "loops that end": "reg [9:0] a; reg [3:0] n; integer i, j; assign LEDR = a;\n"
    "always @(*) begin a = 0; n = SW; for (i = 0; i < 5000; i = i + 1) a = a + 1;\n"
    "for (j = 0; j < n; j = j + 1) a = a ^ j; while (n != 0) n = n >> 1;\n"
    "for (i = 9; i >= 0; i = i - 1) a[i] = SW[i]; repeat (4) a = a << 1; end\n",
    "a memory beside what a reset clears": "reg [31:0] m [0:4095]; reg [9:0] q; assign LEDR = q;\n"
    "always @(posedge CLOCK_50 or negedge KEY[0])\n"
    "if (!KEY[0]) q <= 0; else begin m[SW] <= SW; q <= m[SW]; end\n",
    "an index that is never taken": "parameter P = 0; assign LEDR = P ? SW[10] : SW[0];\n",
    "a parameter of an instance": "defparam u.P = 1; sub u(SW[0], LEDR[0]);\n"
    "assign LEDR[9:1] = 0;\n",
    "pins that are released as a whole": "wire [9:0] w; assign w = 10'bz; assign w[0] = SW[0];\n"
    "assign LEDR = w;\n",
    "an initial value": "reg [9:0] a = 3, b; initial b = 4; assign LEDR = a ^ b;\n"
    "always @(posedge CLOCK_50) begin a <= SW; b <= a; end\n",
    "set and reset": "reg a, b, c; assign LEDR = {a, b, c}; wire r = KEY[0], s = KEY[1];\n"
    "always @(posedge CLOCK_50 or negedge r or posedge s)\n"
    "if (!r) a <= 0; else if (s) a <= 1; else a <= SW[0];\n"
    "always @(posedge CLOCK_50, negedge r) if (r == 1'b0) b <= 0; else b <= SW[1];\n"
    "always @(posedge CLOCK_50 or negedge KEY[2]) begin if (~KEY[2]) c <= 0; else c <= a; end\n",
    "an input of another width": "wire [3:0] q; assign LEDR = q; sub u(SW[3:0], q[0]);\n"
    "assign q[3:1] = 0;\n",
    "constants in pieces": "assign LEDR[4:0] = 5'd1; assign LEDR[9:5] = 5'd2;\n",
    "a task and a function": "reg [9:0] a; assign LEDR = a;\n"
    "function [9:0] f; input [9:0] x; f = x + 10'd1; endfunction\n"
    "task t; begin a = f(SW); end endtask\nalways @(*) t;\n",
    "names that are words of SystemVerilog": "wire bit, do, byte; assign {bit, do, byte} = SW;\n"
    "assign LEDR[2:0] = {bit, do, byte};\nreg int; always @(*) begin int = bit; end\n",
    "a bench beside the design": "assign LEDR = SW; endmodule\nmodule bench; reg c; real r;\n"
    "initial begin c = 0; forever #5 c = ~c; end\n"
    "initial begin @(posedge c); wait (c); r = $random; end\n",
    "logic in a block without a list": "reg [9:0] a; assign LEDR = a;\n"
    "always begin a <= 1; case (SW) 1: a <= 2; endcase end\n",
    "an empty statement": "reg a; always @(*) begin ; a = 1;; end\nassign LEDR = a;\n",
    "a list of all": "reg [9:0] a; assign LEDR = a; always @(*) a = SW;\n"
    "reg b; always @* b = SW[0]; always @(posedge CLOCK_50 or negedge KEY[0]) ;\n",
}


class Messages(Case):
    def write_files(self, files):
        for name, text in (files if isinstance(files, dict) else {"top.v": files}).items():
            (self.folder / name).write_text(text)

    def test_what_quartus_warns_of(self):
        for number, (files, said) in WARNINGS.items():
            with self.subTest(number=number):
                self.setUp()
                self.write_files(files)
                done = self.de1sim("check", ".")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn(said, done.stdout)
                self.assertEqual(len(re.findall(rf"\b{number}: ", done.stdout)), 1, done.stdout)

    def test_what_quartus_refuses(self):
        for number, (files, said) in ERRORS.items():
            with self.subTest(number=number):
                self.setUp()
                self.write_files(files)
                self.refused(said)

    def test_what_is_no_verilog_for_quartus(self):
        for kind, body, said in SYNTAX:
            with self.subTest(body):
                self.setUp()
                self.write_files({f"top.{kind}": WIRE + ALL + body + "\n" + END + SUB})
                self.refused(said)

    def test_an_output_that_is_open_inside_is_a_driver(self):
        self.write(top_v=WIRE + "wire [3:0] v;\nsub s(.a(v), .q(LEDR[3:0]));\nassign v = SW;\n"
                         "assign LEDR[9:4] = 0;\n" + END +
                         "module sub(output [3:0] a, q); assign q = a; endmodule\n")
        self.refused("top.v:4: Quartus error 10028: v has two drivers, here by an assign and at "
                     "top.v:3 by a of instance s (10029)")

    def test_of_vhdl_what_ghdl_refuses_or_loses(self):
        """GHDL 2 names the process and loses a register; later releases name what is assigned."""
        place = 4 if GHDL < 3 else 7
        lost = ("GHDL leaves out n, which is loaded without a clock" if GHDL < 3 else
                "top.vhd:6: Quartus error 10028: n has two drivers, or keeps its value without a")
        for process, said in (
                ("process (CLOCK_50) begin if rising_edge(CLOCK_50) then n <= SW; end if; end "
                 "process;\nprocess (KEY) begin if KEY(0) = '0' then n <= \"0000000000\"; end if; "
                 "end process;\n", f"top.vhd:{place}: Quartus error 10028: n has two drivers"),
                ("process (CLOCK_50, KEY, SW) begin if KEY(0) = '0' then n <= SW;\n"
                 "elsif rising_edge(CLOCK_50) then n <= n; end if; end process;\n",
                 lost)):
            with self.subTest(said):
                self.setUp()
                self.write(top_vhd=VHDL + process + VHDL_END)
                self.refused(said)

    def test_delays_in_place_of_events_are_warned_of(self):
        self.write(top_v=WIRE + ALL + "reg n; always #5 n = ~n;\n" + END)
        self.checked("top.v:3: always needs a list of events, as in @(posedge CLOCK_50)")

    def test_what_quartus_takes_is_taken(self):
        for what, body in TAKEN.items():
            with self.subTest(what):
                self.setUp()
                self.write(top_v=WIRE + body + END +
                           "module sub(input a, output q); parameter P = 0; assign q = a ^ P; "
                           "endmodule\n")
                done = self.de1sim("check", ".")
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_design_in_order_has_no_warning(self):
        self.write(top_v=REG + "reg [9:0] n = 0;\nalways @(posedge CLOCK_50 or negedge KEY[0])\n"
                         "if (!KEY[0]) n <= 0;\nelse if (n == 10'd9) n <= 10'd0;\n"
                         "else n <= n + 10'd1;\n"
                         "always @(*)\ncase (KEY[2:1])\n2'd0: LEDR = n;\n2'd1: LEDR = SW;\n"
                         "2'd2: LEDR = {9'd0, KEY[3]};\n2'd3: LEDR = 10'd5;\nendcase\n" + END)
        self.assertNotIn("warnings", self.de1sim("check", ".").stdout)

    def test_a_run_counts_the_warnings(self):
        self.write(top_v=WIRE + "wire [9:0] c;\nassign LEDR = SW ^ c;\n" + END)
        self.assertIn("3 warnings as Quartus would give; `de1sim check` lists them",
                      self.leds(0))

    def test_the_table_has_each_number(self):
        rows = re.findall(r"^\| (\d{5,6})", README, re.MULTILINE)
        self.assertEqual(sorted(map(int, rows)), sorted([*WARNINGS, *ERRORS]))


if __name__ == "__main__":
    run()
