"""dialect_test.py DE1SIM FOLDER [CASE...] - Verilog as Quartus takes it, and Verilator does not."""
from case import LEDS, Case, run


class AsQuartusTakesIt(Case):
    def test_odd_verilog(self):
        self.write(top_v="module sub(input a, output b); assign b = a; endmodule\n"
                         "module top(input [9:0] SW, output [9:0] LEDR);\n"
                         "wire do = SW[0]; reg [3:0] q;\n"
                         "sub (.a(do), .b(LEDR[0]),);\n"
                         "always @* begin q = 4'b010101; q[1] = SW[1]; end\n"
                         "sub s(.more(), .a(SW[9]), .none(), .b(LEDR[5]), .c());\n"
                         "assign LEDR[4:1] = q; assign LEDR[9:6] = 0;\nendmodule\n")
        self.leds(0b1011, 1)
        self.leds(0b101010, 1 << 9)
        self.checked("top.v:4: dropped the comma", 'top.v:3: "do" is read as a name',
                     "top.v:4: named the instance of sub", "top.v:5: 4'b010101 has too many digits",
                     "top.v:6: left out port c, which")

    def test_an_instance_may_be_called_like_another_module(self):
        self.write(top_v="module low(output q, input d); assign q = ~d; endmodule\n"
                         "module high #(parameter N = 1) (d, q); input d; output q;\n"
                         "assign q = d ^ N[0]; endmodule\n"
                         "module top(input [9:0] SW, output [9:0] LEDR); reg on = 1;\n"
                         "high #(0) low(on, LEDR[1]); high high(.d(SW[0]), .q(LEDR[0]));\n"
                         "always @(posedge SW[9]) on <= 0; endmodule\n")
        self.leds(0b11)
        self.leds(0b10, 1)

    def test_what_is_for_simulators_in_an_included_file(self):
        self.write(top_v="`include \"rtl/facts.vh\"\n"
                         "module top(input [9:0] SW, output [9:0] LEDR); assign LEDR = `VALUE;\n"
                         "endmodule\n",
                   rtl__facts_vh="`define VALUE SW\n"
                                 "// synthesis translate_off\n`undef VALUE\n`define VALUE 10'd7\n"
                                 "// synthesis translate_on\n`include \"rtl/more.vh\"\n",
                   rtl__more_vh="// pragma translate_off\nthis is no Verilog\n"
                                "// pragma translate_on\n")
        self.leds(0b1001, 0b1001)

    def test_an_included_module_is_read_as_quartus_reads_it(self):
        self.write(top_v='`include "part.v"\n' + LEDS.format("part_q").replace(
            "assign", "wire [9:0] part_q; part p(part_q);\nassign"),
                   part_v="module part(output [9:0] q);\nparameter C = 9'h000100007;\n"
                          "assign q = C;\nendmodule\n")
        self.leds(7, top="top")

    def test_an_included_file_that_has_changed(self):
        self.write(top_v="`include \"facts.vh\"\n" + LEDS.format("`VALUE"),
                   facts_vh="`include \"more.vh\"\n", more_vh="`define VALUE 10'd21\n")
        self.leds(21)
        self.write(more_vh="`define VALUE 10'd42\n")
        self.leds(42)

    def test_tri_state_gates(self):
        self.write(top_v="module top(input [9:0] SW, output [9:0] LEDR, inout [35:0] GPIO_0);\n"
                         "tri y, z; wire n;\n"
                         "bufif1 b1 (y, SW[0], SW[9]), (n, SW[4], 1'b1);\n"
                         "bufif0 #(1,\n 2) b0 (y, SW[1], SW[9]);\n"
                         "notif1 (strong0, strong1) (z, SW[2], ~SW[9]);\n"
                         "notif0 n0 (z, SW[3], ~SW[9]);\n"
                         "bufif1 (GPIO_0[0], SW[2], SW[8]==1); bufif0 (GPIO_0[1], SW[3], SW[8]);\n"
                         "assign LEDR = {GPIO_0[1:0], n, z, y};\nendmodule\n")
        self.leds(0b01011, 0b0000000010)  # the pin that is released is high
        self.leds(0b11001, 0b1000001101)
        self.leds(0b11101, 0b0100010110)
        self.leds(0b10010, 0b1100000000)

    def test_wired_nets(self):
        self.write(top_v="module sub(output [1:0] q, input d); assign q = {d, 1'b1}; endmodule\n"
                         "module top(input [9:0] SW, output [9:0] LEDR);\n"
                         "wand a; wor b, c; wand [1:0] d;\n"
                         "assign a = SW[0];\nassign a = SW[1], b = SW[2];\n"
                         "assign b = SW[3]; and (c, SW[4], SW[5]); or o (c, SW[6], 1'b0);\n"
                         "sub s (.q(d), .d(SW[7])); assign d[1] = SW[8];\n"
                         "assign LEDR = {d, c, b, a};\nendmodule\n")
        self.leds(0b01000, 0)
        self.leds(0b01000, 0b0010000001)
        self.leds(0b11111, 0b0110110111)
        self.leds(0b01110, 0b0101001001)

    def test_loops_as_long_as_the_project_wants(self):
        qsf = "set_global_assignment -name {} {}\n"
        self.write(top_v="module top(input [9:0] SW, output reg [9:0] LEDR); integer i;\n"
                         "always @(*) begin LEDR = SW; for (i = 0; i < 6000; i = i + 1)\n"
                         "  LEDR = LEDR ^ i; end\nendmodule\n",
                   p_qsf=qsf.format("TOP_LEVEL_ENTITY", "top") + qsf.format("VERILOG_FILE", "top.v")
                         + qsf.format("VERILOG_CONSTANT_LOOP_LIMIT", 10000))
        self.checked("top.v")
        self.write(p_qsf=qsf.format("VERILOG_FILE", "top.v")
                         + qsf.format("VERILOG_CONSTANT_LOOP_LIMIT", 10))
        self.refused("Quartus error 10106: the loop has more than 10 rounds", "check", ".",
                     "--top", "top")
        self.write(p_qsf=qsf.format("VERILOG_CONSTANT_LOOP_LIMIT", "many"))
        self.refused('p.qsf:1: VERILOG_CONSTANT_LOOP_LIMIT is "many", expected a number of rounds')

    def test_an_inout_port_on_an_input(self):
        self.write(top_v="module pin(inout p, input on, output seen);\n"
                         "assign p = on ? 1'b0 : 1'bz; assign seen = p; endmodule\n"
                         "module top(input [9:0] SW, output [9:0] LEDR);\n"
                         "pin u (SW[0], 1'b0, LEDR[0]); assign LEDR[9:1] = 0; endmodule\n")
        self.leds(1, 1)

    def test_blocking_and_non_blocking_mixed(self):
        self.write(top_v="module top(input CLOCK_50, output [9:0] LEDR); reg [9:0] n;\n"
                         "always @(posedge CLOCK_50) if (n < 100) n = n + 1; else n <= 5;\n"
                         "assign LEDR = n < 200; endmodule\n")
        self.leds(1)

    def test_a_register_by_a_blocking_assignment(self):
        """What other blocks get of it at the same edge is what it was before."""
        self.write(top_v="module top(input CLOCK_50, output [9:0] LEDR);\n"
                         "reg [4:0] n = 0, m = 0, d = 0;\n"
                         "always @(posedge CLOCK_50) n = n + 1;\n"
                         "always @(posedge CLOCK_50) m = n;\n"
                         "always @(posedge CLOCK_50) d <= n - m;\n"
                         "assign LEDR = d; endmodule\n")
        self.leds(1)

    def test_a_register_by_both_assignments_in_always_ff(self):
        """Verilator alone loses the "=" of a variable that the block also sets by "<="."""
        self.write(top_sv="module top(input CLOCK_50, input [3:0] KEY, output logic [9:0] LEDR);\n"
                          "logic [9:0] n = 0; logic up = 1, down = 1;\n"
                          "always_ff @(posedge CLOCK_50, negedge KEY[1])\n"
                          "  if (!KEY[1]) begin n <= 0; up <= 1; end\n"
                          "  else if (up) begin n = n + 10'd1; if (n == 10'd300) up <= 0; end\n"
                          "  else if (n != 10'd450) n <= n + 10'd5;\n"
                          "always_ff @(posedge CLOCK_50) if (!up) LEDR = n; else LEDR <= 7;\n"
                          "endmodule\n")
        self.leds(450, wait="60ms")
        self.leds(7, wait="1us")

    def test_a_register_by_both_assignments_beside_a_task(self):
        self.write(top_v="module top(input CLOCK_50, output reg [9:0] LEDR);\n"
                         "reg [9:0] n = 0, seen = 0;\n"
                         "task look(input [9:0] more); begin seen <= n + more; end endtask\n"
                         "task stop; LEDR <= seen; endtask\n"
                         "always @(posedge CLOCK_50) begin\n"
                         "  if (n == 0) n = 300; else if (n < 305) n <= n + 1;\n"
                         "  look(10'd7); stop; end\n"
                         "endmodule\n")
        self.leds(312, wait="60ms")

    def test_parts_of_a_register_by_both_assignments(self):
        self.write(top_sv="module top(input CLOCK_50, output logic [9:0] LEDR);\n"
                          "logic [9:0] n = 0, m = 0;\n"
                          "always_ff @(posedge CLOCK_50) begin\n"
                          "  n[3:0] = 4'd5; n[9:8] <= 2'd2; if (n[0]) n[5] <= 1; n[4]++; end\n"
                          "always_ff @(posedge CLOCK_50) {m[4:0], m[9:5]} = n;\n"
                          "assign LEDR = m & 10'b0111111111; endmodule\n")
        self.leds(0b10110001)

    def test_a_counter_that_its_block_reads_is_a_register_for_others(self):
        """At each edge the other block gets what it was before, whichever stands first."""
        count = ("always @(posedge CLOCK_50) begin\n"
                 "  n = n + 1; if (n == 10) begin n = 0; t = ~t; end end\n")
        other = ("always @(posedge CLOCK_50) begin\n"
                 "  m <= n; if (m == n) bad <= 1; if (n == 10) bad <= 1; end\n")
        for body in count + other, other + count:
            self.write(top_v="module top(input CLOCK_50, output [9:0] LEDR);\n"
                             "reg [3:0] n = 5, m = 0; reg t = 0, bad = 0;\n" + body +
                             "reg [3:0] d = 0; always @(posedge CLOCK_50) d <= n - m;\n"
                             "reg same = 1; always @(posedge CLOCK_50) same <= d == 1 || d == 7;\n"
                             "assign LEDR = {bad, same}; endmodule\n")
            self.leds(1)

    def test_a_list_that_lacks_signals_is_that_of_all(self):
        self.write(top_v="module top(input [9:0] SW, output [9:0] LEDR); reg a, b, c;\n"
                         "always @(SW[0]) a = SW[0] & SW[1];\n"
                         "always @(SW[0] or SW[1]) begin c <= b; b <= SW[0] & SW[1]; end\n"
                         "assign LEDR = {c, b, a};\nendmodule\n")
        self.plays("hold: {switch: 0}", "delay: 1ms", "hold: {switch: 1}", "delay: 60ms",
                   'expect-leds: "0000000111"', "release: {switch: 1}", "delay: 60ms",
                   'expect-leds: "0000000000"')

    def test_translate_off(self):
        """What stands there is not read, not even its lines for the preprocessor."""
        leds = "module top(output [9:0] LEDR);\n"
        for n, (off, on) in enumerate((
                ("// synthesis translate_off", "// synthesis translate_on"),
                ("// synopsys translate_off", "//synopsys  translate_on"),
                ("//pragma translate_off", "// pragma translate_on"),
                ("/* synthesis translate_off */", "/* Synthesis TRANSLATE_ON */"),
                ("// altera translate_off // ModelSim", "// altera translate_on"))):
            leds += (f"{off}\n`define SIM\nthis is no Verilog \"\n{on}\n"
                     f"`ifdef SIM\nassign LEDR[{n}] = 0;\n`else\nassign LEDR[{n}] = 1;\n`endif\n"
                     f"{off}\nassign LEDR[{n}] = 0; missing m();\n"
                     f"// synthesis read_comments_as_HDL on\n{on}\n")
        self.write(top_v=leds + "assign LEDR[9:5] = 0;\nendmodule\n// pragma translate_off\nend")
        self.leds(31)

    def test_comments_that_are_read(self):
        self.write(top_v="module top(output [9:0] LEDR);\n"
                         "// synthesis read_comments_as_HDL on\n// assign LEDR = 6;\n"
                         "/* wire [3:0] more; */ // synthesis read_comments_as_HDL off\n"
                         "// assign LEDR = 9;\nendmodule\n")
        self.leds(6)

    def test_translate_off_in_a_branch_that_is_not_taken(self):
        """The wizards' files have it in one that is for other tools than Quartus."""
        self.write(top_v="module top(output [9:0] LEDR);\n`ifndef ALTERA_RESERVED_QIS\n"
                         "// synopsys translate_off\n`endif\ntri1 [9:0] w;\n"
                         "`ifndef ALTERA_RESERVED_QIS\n// synopsys translate_on\n`endif\n"
                         "assign LEDR = w;\nendmodule\n")
        self.leds(1023)

    def test_macros_are_those_of_quartus(self):
        self.write(top_v="module top(output [9:0] LEDR);\n`ifdef ALTERA_RESERVED_QIS\n"
                         "`ifndef VERILATOR\n`ifndef verilator\nassign LEDR = 6;\n"
                         "`endif\n`endif\n`endif\nendmodule\n")
        self.leds(6)

    def test_a_parameter_that_is_set_twice(self):
        """The last one counts, of each instance of a name in its own block."""
        self.write(top_v="module part(output [9:0] q); parameter A = 0, B = 0;\n"
                         "assign q = A + B; endmodule\n"
                         "module top(output [9:0] LEDR); wire [9:0] a, b;\n"
                         "defparam u.A = 16, u.B = 3,\n  u.B = 5;\npart u(LEDR);\n"
                         "generate if (1) begin : x defparam p.A = 1; part p(a); end\n"
                         "if (1) begin : y defparam p.A = 2; part p(b); end endgenerate\n"
                         "reg ok; always @* ok = a == 1 && b == 2;\n"
                         "endmodule\n")
        self.leds(21)
        self.checked("top.v:4: left out defparam u.B, which is set again")

    def test_an_inout_port_of_another_width_than_its_wire(self):
        self.write(top_v="module pad(inout [7:0] io, input [7:0] d, input on, output [7:0] q);\n"
                         "assign io = on ? d : 8'bz; assign q = io; endmodule\n"
                         "module top(output [9:0] LEDR); tri [15:0] wide; tri [3:0] narrow;\n"
                         "wire [7:0] a, b, c;\n"
                         "pad p(.io(wide), .d(8'd5), .on(1'b1), .q(a));\n"
                         "pad q(.io(narrow), .d(8'd6), .on(1'b1), .q(b));\n"
                         "pad r(.io(UNKNOWN), .d(8'd1), .on(1'b1), .q(c));\n"
                         "assign LEDR = {c[0], b[3:0], wide[3:0]};\nendmodule\n")
        self.leds(0b101100101)

    def test_comments_for_a_newer_verilator(self):
        self.write(top_v="/* verilator lint_off WIDTHEXPAND */\n" + LEDS.format("SW[1:0]") +
                         "// verilator lint_off WIDTHTRUNC\n")
        self.leds(3, 3)

    def test_a_wire_that_a_block_assigns_in_system_verilog(self):
        self.write(top_sv="module top(input CLOCK_50, output wire [9:0] LEDR); wire [9:0] n;\n"
                          "always_ff @(posedge CLOCK_50) n <= 10'd9;\n"
                          "always_comb LEDR = n;\nendmodule\n")
        self.leds(9)

    def test_an_array_that_a_long_loop_assigns(self):
        self.write(top_v="module top(input CLOCK_50, output [9:0] LEDR);\n"
                         "reg [3:0] m [0:1199]; integer i; reg first = 1;\n"
                         "always @(posedge CLOCK_50)\n"
                         "if (first) begin first <= 0; for (i = 0; i < 1200; i = i + 1)\n"
                         "  m[i] <= 4'd7; end\nelse m[3] <= 4'd9;\n"
                         "assign LEDR = {m[1199], m[3]};\nendmodule\n")
        self.leds(0b1111001)

    def test_files_are_system_verilog_where_the_settings_say_so(self):
        self.write(p_qsf="set_global_assignment -name VERILOG_INPUT_VERSION SYSTEMVERILOG_2005\n"
                         "set_global_assignment -name VERILOG_FILE top.v\n"
                         "set_global_assignment -name TOP_LEVEL_ENTITY top\n",
                   top_v="module top(output [9:0] LEDR);\n"
                         "for (genvar i = 0; i < 10; i++) assign LEDR[i] = i % 2;\nendmodule\n")
        self.leds(0b1010101010)

    def test_pulls_of_the_wizards_files(self):
        """tri0 and tri1 in the wizard's file and where it is instanced: the memory must write."""
        self.write(top_v="module top(input CLOCK_50, output [9:0] LEDR);\n"
                         "reg [3:0] n = 0; always @(posedge CLOCK_50) n <= n + 1;\n"
                         "tri1 clock = CLOCK_50; tri0 wren = 1;\n"
                         "ram r (.address(n), .clock(clock), .data({n, n}), .wren(wren),\n"
                         "  .q(LEDR[7:0]));\n"
                         "assign LEDR[9:8] = 0; endmodule\n",
                   ram_v="module ram(address, clock, data, wren, q);\n"
                         "input [3:0] address; input clock; input [7:0] data; input wren;\n"
                         "output [7:0] q; tri1 clock; tri0 wren;\n"
                         "altsyncram a (.address_a(address), .clock0(clock), .data_a(data),\n"
                         "  .wren_a(wren), .q_a(q));\n"
                         "defparam a.operation_mode = \"SINGLE_PORT\", a.width_a = 8,\n"
                         "  a.widthad_a = 4, a.numwords_a = 16,\n"
                         "  a.outdata_reg_a = \"UNREGISTERED\",\n"
                         "  a.read_during_write_mode_port_a = \"NEW_DATA_NO_NBE_READ\";\n"
                         "endmodule\n")
        done = self.plays("delay: 1ms")
        self.assertRegex(done.stdout, r"LEDR 00(\d{4})\1")
        self.assertNotIn("LEDR 0000000000", done.stdout)

    def test_a_buffer_inside_the_chip_is_a_wire(self):
        """But one that another name takes to a pin."""
        self.write(top_v="""\
module inverter(input a, output y); assign y = ~a; endmodule
module top(input [9:0] SW, output [9:0] LEDR, inout [35:0] GPIO_0);
tri a;
assign a = SW[0] ? 1'bz : SW[1];
inverter i(.a(a), .y(LEDR[0]));
wire [2:0] b = SW[2] ? SW[5:3] : {3{1'bz}};
assign LEDR[3:1] = b + 3'd1, LEDR[9:4] = 6'd0;
wire c = SW[0] ? 1'b0 : 1'bz;
assign GPIO_0[3] = c;
endmodule
""")
        self.checked("top.v:4: 13049: a is released inside the chip", "top.v:6: 13049: b is")
        self.assertNotIn("top.v:9: 10230", self.de1sim("check", ".").stdout)
        self.plays('expect-leds: "0000000011"', "hold: {switch: [0, 1, 3]}", "delay: 1us",
                   'expect-leds: "0000000100"', "expect-pins: {gpio_0: 3, level: low}",
                   "release: {switch: 0}", "delay: 1us",
                   "expect-pins: {gpio_0: 3, level: high}")

    def test_an_output_that_is_connected_with_a_number(self):
        """As in an example on the board's CD."""
        self.write(top_v="module part(input a, output y, output z);\n"
                         "assign y = a, z = ~a; endmodule\n"
                         "module top(input [9:0] SW, output [9:0] LEDR);\n"
                         "part p(.a(SW[0]), .y(1'b1), .z(LEDR[0]));\n"
                         "part q(SW[1], LEDR[1], 0);\nassign LEDR[9:2] = 0; endmodule\n")
        self.leds(0b0000000010, 0b0000000011)
        self.checked("top.v:4: left output y open, which is connected with 1'b1",
                     "top.v:5: left output z open, which is connected with 0")

    def test_a_register_that_is_released_inside_the_chip(self):
        """In an instance, too; a choice, a part and a case."""
        self.write(top_v="""\
module words(input clk, input [1:0] at, input read, output reg [3:0] q, output reg [1:0] r);
always @(posedge clk)
    if (read) case (at)
        2'b01: q <= 4'd5;
        2'b10: q <= 4'd6;
        default: q <= 4'bzzzz;
    endcase
always @(*) begin
    r[0] = (read ? at[0] : 1'bz);
    if (read) r[1] = at[1]; else r[1] = 1'hz;
end
endmodule
module top(input CLOCK_50, input [9:0] SW, output [9:0] LEDR);
wire [3:0] q; wire [1:0] r;
words w(.clk(CLOCK_50), .at(SW[1:0]), .read(SW[9]), .q(q), .r(r));
assign LEDR = {q + 4'd1, r + 2'd0};
endmodule
""")
        self.checked("top.v:6: 13049: q is released inside the chip", "top.v:9: 13049: r is")
        self.leds(0b0000011001, 0b1000000001)
        self.leds(0b0000011110, 0b1000000010)

    def test_registers_that_are_released_at_a_pin(self):
        """Clocked and not, as a whole and in part, by a choice, in an instance, with a value."""
        self.write(top_v="""\
module open_drain(input clk, input low, inout p);
reg r = 1'bz;
always @(posedge clk) r <= #1 low ? 1'b0 : (1'bz);
assign p = r;
endmodule
module halves(input [1:0] on, input [3:0] d, output reg [3:0] q, output n);
reg a, b;
assign n = a;
always @(*) begin
    a = d == 4'd5;
    case (on)
        2'd1: q = {2'bz, d[1:0]};
        2'd2: q[3:2] = d[3:2];
        default: q = {4{1'bz}};
    endcase
    if (on == 2'd2) q[1:0] = 2'bzz;
end
endmodule
module top(input CLOCK_50, input [9:0] SW, output [9:0] LEDR, inout FPGA_I2C_SDAT, PS2_CLK,
           inout [3:0] GPIO_0, output reg signed [1:0] GPIO_1, HEX0);
reg sda, unused; wire n;
always @(posedge CLOCK_50) if (SW[0]) sda <= 1'b0; else sda <= 1'bz;
assign FPGA_I2C_SDAT = sda;
open_drain o(CLOCK_50, SW[1], PS2_CLK);
halves h(SW[3:2], SW[7:4], GPIO_0, n);
always @(*) begin HEX0 = SW[9:8]; if (SW[8]) GPIO_1 = -1; else GPIO_1 = 2'bzz; end
assign LEDR = {n, HEX0, 1'b0, GPIO_0, PS2_CLK, FPGA_I2C_SDAT};
endmodule
""")
        self.leds(0b0000111111, 0b0000000000)
        self.leds(0b0000111100, 0b0010100011)
        self.leds(0b1000110111, 0b0001010100)
        self.leds(0b0000101111, 0b0010101000)

    def test_logic_that_is_released_at_a_pin(self):
        self.write(top_sv="""\
module top(input [9:0] SW, output [9:0] LEDR, inout PS2_CLK, inout [1:0] GPIO_0);
logic c; logic [1:0] d, other;
always_comb begin other = SW[3:2]; c = SW[0] ? 1'b0 : 1'bz; if (SW[1]) d = other; else d = 'z; end
assign PS2_CLK = c, GPIO_0 = d, LEDR = {GPIO_0, 7'd0, PS2_CLK};
endmodule
""")
        self.leds(0b1100000001)
        self.leds(0b0100000000, 0b0000000111)

    def test_an_output_that_is_released_and_read(self):
        """By an assignment, and by an instance of an instance with an inout."""
        self.write(top_v="""\
module pad(inout p, input low, output q); assign p = low ? 1'b0 : 1'bz; assign q = p; endmodule
module master(scl, low, seen);
output scl;
input low;
output seen;
pad pad(.p(scl), .low(low), .q(seen));
endmodule
module top(input [9:0] SW, output FPGA_I2C_SCLK, output [9:0] LEDR, output wire PS2_CLK);
master m(.scl(FPGA_I2C_SCLK), .low(SW[0]), .seen(LEDR[0]));
assign PS2_CLK = SW[1] ? 1'b0 : 1'bz;
assign LEDR[9:1] = PS2_CLK;
endmodule
""")
        self.plays('expect-leds: "0000000011"', "hold: {switch: 0}", "delay: 1us",
                   'expect-leds: "0000000010"', "hold: {switch: 1}", "delay: 1us",
                   'expect-leds: "0000000000"')

    def test_two_buffers_take_turns_on_a_pin_and_on_a_part_of_a_bus(self):
        self.write(top_v="""\
module top(input [9:0] SW, output [9:0] LEDR);
wire [3:0] bus;
assign LEDR[0] = SW[0] ? SW[1] : 1'bz;
assign LEDR[0] = SW[0] ? 1'bz : SW[2], LEDR[5:1] = 0;
assign bus[0] = SW[0] ? 1'b1 : 1'bz, bus[3:1] = 3'd5;
assign bus[0] = ~SW[0] ? 1'b0 : 1'bz;
assign LEDR[9:6] = bus;
endmodule
""")
        self.leds(0b1010000001, 0b100)
        self.leds(0b1011000000, 0b101)
        self.leds(0b1011000001, 0b011)

    def test_a_file_for_readmemh_is_read_at_run_time(self):
        self.write(top_v="module top(output [9:0] LEDR); reg [7:0] m [0:3];\n"
                         'initial $readmemh("words.hex", m); assign LEDR = m[2]; endmodule\n',
                   words_hex="01 02 a5 04\n")
        self.leds(0xA5)
        self.write(words_hex="01 02 3c 04\n")
        self.assertNotIn("translating", self.leds(0x3C))

    def test_a_type_that_several_parameters_share(self):
        self.write(top_v=LEDS.format("y").replace("; assign", "; wire [9:0] y; sub #(.A(1), .B(3)) "
                                                              "s(y); assign") +
                   "module sub #(parameter [1:0] A = 0, B = 0) (output [9:0] q);\n"
                   "assign q = {A, B, 1'b0}; endmodule\n")
        self.leds(0b01110)
        self.checked("top.v:2: repeated the type of parameter B: [1:0]")


if __name__ == "__main__":
    run()
