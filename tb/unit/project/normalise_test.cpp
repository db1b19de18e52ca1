// What Quartus takes and Verilator does not, and what must stay as it is.
#include "sim/verilog/normalise.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using sim::project::normalise;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string cleaned(const std::string& text) { return normalise(text, "f.v", false).text; }

TEST(Normalise, LeavesAsItIsWhatIsInOrder) {
    const std::string text =
        "module m(input a, output b);\n  sub u (.a(a), .b(), .c(8'hff));\n"
        "  always @* begin if (a) $display(\"4'b00000 ,)\"); end\nendmodule\n";
    const auto result = normalise(text, "f.v", false);
    EXPECT_EQ(result.text, text);
    EXPECT_THAT(result.changes, IsEmpty());
}

TEST(Normalise, ExecutesAsynchronousResetsAtPowerUp) {
    const auto added = [](const std::string& text) {
        const std::string clean = cleaned(text);
        return clean.substr(text.size());
    };
    EXPECT_EQ(added("always_ff @(posedge c, posedge r) if (r) q <= {2'b10, K}; else q <= d;"),
              " initial q <= {2'b10, K};");
    EXPECT_EQ(added("always @(posedge c or negedge r) begin : b if (~r) begin a <= 1; b <= 2; end\n"
                    "if (e) f <= 1; if (r == 0) g <= 3; else g <= 4; end"),
              " initial begin a <= 1; b <= 2; end initial g <= 3;");
    for (const char* none :
         {"always @(posedge c) if (r) q <= 1; else q <= d;",
          "always @(posedge c or posedge r) if (e) q <= 1;",
          "always @(posedge c or posedge r) if (r) begin $display(1); q <= 1; end",
          "always @(posedge c or posedge r) if (r)\n`ifdef A\nq <= 1;\n`endif\n"})
        EXPECT_EQ(cleaned(none), none);
}

TEST(Normalise, BeginsVariablesOfABlockAtPowerUp) {
    EXPECT_EQ(cleaned("always @(posedge c) begin reg [1:0] n = 2'd3, m; n <= m; end"),
              "initial de1sim_block_6.n = 2'd3; always @(posedge c) begin : de1sim_block_6 reg "
              "[1:0] n  , m; n <= m; end");
    EXPECT_EQ(cleaned("always @(posedge c) begin : a if (x) begin : b reg k=K; end end"),
              "initial a.b.k = K; always @(posedge c) begin : a if (x) begin : b reg k; "
              "end end");
    EXPECT_EQ(cleaned("always @(posedge c) begin : a logic n = f(1, 2)[0]; end"),
              "initial a.n = f(1, 2)[0]; always @(posedge c) begin : a logic n   ; end");
    for (const char* none :
         {"always @* begin reg n = 0; end", "always @(posedge c) begin reg n; n = 1; end",
          "always @(posedge c) begin reg n [0:1] = '{0, 1}; end"})
        EXPECT_EQ(cleaned(none), none);
}

TEST(Normalise, LeavesOutConcurrentAssertions) {
    const auto result = normalise(
        "module m;\nproperty p;\n  @(posedge c) a |=> ##[0:K] b;\nendproperty : p\n"
        "check: assert property (p) else $error(\"late\");\nsequence s; a ##1 b; endsequence\n"
        "always_ff @(posedge c) begin q <= d; cover property (s); end\n"
        "assume property (@(posedge c) a) begin x = 1; end else y = 1; assign z = q;\n"
        "always_comb assert (a) else $error(\"now\");\nendmodule\n",
        "f.sv", true);
    const std::string& text = result.text;
    for (const char* gone : {"property", "sequence", "check", "late", "x = 1", "y = 1"})
        EXPECT_EQ(text.find(gone), text.npos) << gone;
    for (const char* kept : {"\nalways_ff @(posedge c) begin q <= d;", "; end\n", "assign z = q;",
                             "assert (a) else $error(\"now\");\nendmodule"})
        EXPECT_THAT(text, HasSubstr(kept));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
    EXPECT_THAT(result.changes, ElementsAre("f.sv:2: left out the concurrent assertions, which "
                                            "Quartus ignores"));
    EXPECT_EQ(cleaned("reg property; assign property = a;"),
              "`begin_keywords \"1364-2005\" reg "
              "property; assign property = a;\n`end_keywords\n");
}

TEST(Normalise, NamesInstances) {
    EXPECT_THAT(cleaned("module m;\nsub (.a(x));\nram #(.W(2)) (.q(y));\nendmodule"),
                HasSubstr("sub de1sim_unnamed_1  (.a(x));\n"
                          "ram #(.W(2)) de1sim_unnamed_2  (.q(y));"));
    EXPECT_THAT(cleaned("module m;\nalways @(posedge c) begin if (a) b <= a; end\nsub (x, y);\n"
                        "endmodule"),
                HasSubstr("sub de1sim_unnamed_1  (x, y);"));
    EXPECT_THAT(cleaned("module m; always @(*) case (a) 1: b = 0; endcase sub (x);"),
                HasSubstr("sub de1sim_unnamed_1  (x);"));
    EXPECT_THAT(cleaned("module m; generate if (W) begin : g sub (x[0], y); end"),
                HasSubstr("sub de1sim_unnamed_1  (x[0], y);"));
}

TEST(Normalise, CallsOfTasksAreNoInstances) {
    for (const char* calls :
         {"initial begin clear(x); wait (y) send(x); end", "always @* begin : name clear(x); end",
          "always @(posedge c) begin case (a) 1: begin clear(x); end endcase send(x); end",
          "task t; begin clear(x); send(y); end endtask",
          "always @(posedge c) begin if (a) b <= 1; else begin clear(x); end clear(y); end",
          "initial fork clear(x); send(y); join", "always begin #10 c = 0; clear(x); end",
          "function f(input i); begin clear(x); f = i; end endfunction"}) {
        const std::string text = std::string{"module m;\n"} + calls + "\nendmodule\n";
        EXPECT_EQ(cleaned(text), text);
    }
}

TEST(Normalise, PutsAPortBeforeItsNet) {
    const auto result = normalise(
        "module m(a, b, c);\nwire [1:0] b, d;\ninput a;\n// two\ninput [1:0] b, c;\nendmodule\n",
        "f.v", false);
    EXPECT_EQ(result.text,
              "module m(a, b, c);\ninput [ 1 : 0 ] b; wire [1:0] b, d;\ninput a;\n// two\n"
              "input [ 1 : 0 ] c;    \nendmodule\n");
    EXPECT_THAT(result.changes, ElementsAre("f.v:5: moved before its net: port b"));
}

TEST(Normalise, LeavesNetsAfterPortsAndOtherModulesAlone) {
    const std::string text =
        "module m(a, q);\ninput a;\noutput [3:0] q;\nwire a;\nreg [3:0] q;\nwire z;\nendmodule\n"
        "module n(z);\ninput z;\nendmodule\n"
        "module p(input x);\nfunction f; input y; reg y; f = y; endfunction\nendmodule\n";
    EXPECT_EQ(cleaned(text), text);
}

TEST(Normalise, RepeatsATypeThatParametersShare) {
    const auto result = normalise(
        "module m import p::*; #(parameter signed [8:0] A = f(1, 2),\nB = 2, localparam C = 3, D = "
        "4,"
        "\nparameter int E = 5, byte F = 6, G = 7) (input x);",
        "f.sv", true);
    EXPECT_EQ(result.text,
              "module m import p::*; #(parameter signed [8:0] A = f(1, 2),\n"
              "parameter signed [8:0] B = 2, localparam C = 3, D = 4,\n"
              "parameter int E = 5, byte F = 6, parameter byte G = 7) (input x);");
    EXPECT_THAT(result.changes,
                ElementsAre("f.sv:2: repeated the type of parameter B: signed [8:0]",
                            "f.sv:3: repeated the type of parameter G: byte"));
}

TEST(Normalise, LeavesParametersWithoutATypeAlone) {
    for (const std::string text :
         {"module m #(parameter A = {2{1'b1}}, B = 2) (input [1:0] x, y);", "module m (input x);",
          "module m #(parameter [8:0] A = 1) (input x, y);",
          "module m; parameter [8:0] A = 1, B = 2; s #(.A(1), .B(2)) u (x); endmodule"})
        EXPECT_EQ(cleaned(text), text);
}

TEST(Normalise, ChargeStrengthsAreNames) {
    EXPECT_EQ(cleaned("wire small, larger;"), "wire \\small , larger;");
}

TEST(Normalise, ShortensLiteralsAsQuartusDoes) {
    EXPECT_EQ(cleaned("x = 4'b010101;"), "x = 4'b0101;");
    EXPECT_EQ(cleaned("x = 4'h1F;"), "x = 4'hF;");
    EXPECT_EQ(cleaned("x = 3'hF;"), "x = 3'h7;");
    EXPECT_EQ(cleaned("x = 4'd17;"), "x = 4'd1;");
    EXPECT_EQ(cleaned("x = 10'b00000_00000;"), "x = 10'b00000_00000;");
    EXPECT_EQ(cleaned("x = 8'shff;"), "x = 8'shff;");
    EXPECT_EQ(cleaned("x = 4'bzzzz;"), "x = 4'bzzzz;");
}

TEST(Normalise, DropsTrailingCommas) {
    EXPECT_EQ(cleaned("module m(input a,\n output b,\n);"), "module m(input a,\n output b\n);");
    EXPECT_EQ(cleaned("sub u (.a(a), );"), "sub u (.a(a) );");
}

// A counter that another block reads at the same edge: both are registers in Quartus.
TEST(Normalise, BlockingAssignmentsMakeRegisters) {
    EXPECT_EQ(cleaned("always @(posedge clk) n = n + 1;"), "always @(posedge clk) n <= n + 1;");
    EXPECT_EQ(cleaned("always @(negedge r or posedge c) begin if (!r) n = 0; else if (n < 9)\n"
                      "n = n + 1; end"),
              "always @(negedge r or posedge c) begin if (!r) n <= 0; else if (n < 9)\n"
              "n <= n + 1; end initial n = 0;");
    EXPECT_EQ(cleaned("always @(posedge c) case (n) 2'd1: begin a = b[0]; d = 1; end\n"
                      "3, 4: a = d; default a[3:0] = m[n]; endcase"),
              "always @(posedge c) case (n) 2'd1: begin a <= b[0]; d <= 1; end\n"
              "3, 4: a <= d; default a[3:0] <= m[n]; endcase");
    EXPECT_EQ(cleaned("always @(posedge c) {a, b} = {b, a};"),
              "always @(posedge c) {a, b} <= {b, a};");
}

TEST(Normalise, VariablesThatTheirBlockReadsStayAsTheyAre) {
    for (const std::string block :
         {"begin n = n + 1; if (n == 9) n = 0; end", "begin t = a; {t, u} = b; v <= t; end",
          "begin if (a) t = b; v[t] <= 1; end", "begin case (a) 1: t = 2; endcase v <= t; end",
          "for (i = 0; i < 4; i = i + 1) s[i] = s[i] ^ p;", "begin : x reg t; t = a; end",
          "begin t = a; go(t); end"})
        EXPECT_EQ(cleaned("always @(posedge c) " + block), "always @(posedge c) " + block);
    EXPECT_EQ(cleaned("always @(posedge c) begin t = a; v = t; end"),
              "always @(posedge c) begin t = a; v <= t; end");
    EXPECT_EQ(cleaned("always @* n = m;"), "always @* n = m;");
    EXPECT_EQ(cleaned("always @(posedge c) n = m + ("), "always @(posedge c) n = m + (");
}

TEST(Normalise, ARegisterOfBothAssignmentsGetsACopy) {
    EXPECT_EQ(cleaned("module m; reg [3:0] n;\nalways_ff @(posedge c) if (r) n <= 0;\n"
                      "else begin n[1] = n[0]; n++; a <= n; end\nendmodule"),
              "module m; reg [3:0] n;\nalways_ff @(posedge c) begin : de1sim_block_1 "
              "reg [ 3 : 0 ] de1sim_d_n; de1sim_d_n = n; if (r) n <= 0;\n"
              "else begin begin de1sim_d_n[1] = de1sim_d_n[0]; n[ 1 ]  <= de1sim_d_n[ 1 ] ; end "
              "begin de1sim_d_n++; n <= de1sim_d_n; end a <= de1sim_d_n; end end\nendmodule");
    // A memory is not copied.
    EXPECT_THAT(cleaned("module m; reg n [0:3]; always @(posedge c) if (r) n[0] <= 0;\n"
                        "else begin n[i] = 1; a <= n[0]; end endmodule"),
                HasSubstr("begin n[i] = 1; n[ i ]  <= n[ i ] ; end"));
}

TEST(Normalise, ARegisterThatOthersReadGetsACopy) {
    const std::string block = "always @(posedge c) begin n = n + 1; if (n == 9) n = 0; end ";
    const std::vector<std::string> seen{
        "module m; reg n; " + block + "always @(posedge c) d <= n; endmodule",
        "module m; reg n; always @(posedge c) d <= n; " + block + "endmodule",
        "module m(output reg [3:0] d, n); " + block + "endmodule",
        "module m(n); output [3:0] n; reg [3:0] n; " + block + "endmodule"};
    for (const std::string& module : seen)
        EXPECT_THAT(cleaned(module), HasSubstr("if (de1sim_d_n == 9)")) << module;
    const std::vector<std::string> alone{
        "module m; reg n; " + block + "endmodule module k; always @(posedge c) n <= 1; endmodule",
        "module m; integer i; always @(posedge c) for (i = 0; i < 2; i = i + 1) a[i] <= 1;\n"
        "always @(posedge c) for (i = 0; i < 2; i = i + 1) b[i] <= 1; endmodule"};
    for (const std::string& module : alone) EXPECT_EQ(cleaned(module), module);
}

TEST(Normalise, AListWithoutEdgesHasAllThatTheBlockReads) {
    EXPECT_EQ(cleaned("always @(a or b[0]) c = a & d;"),
              "always @(`ifdef DE1SIM_LISTS a or b[0] `else * `endif ) c = a & d;");
    EXPECT_EQ(cleaned("always @a c = a;"),
              "always @(`ifdef DE1SIM_LISTS a `else * `endif ) c = a;");
    for (const char* same : {"always @(*) c = a;", "always @* c = a;",
                             "always @(posedge a, negedge b) c <= a;", "initial @(a) b = 1;"})
        EXPECT_EQ(cleaned(same), same);
}

TEST(Normalise, NewKeywordsAreNamesInAVFile) {
    const auto result = normalise("module m(input do, output final);\nendmodule\n", "f.v", false);
    EXPECT_EQ(result.text.find("`begin_keywords \"1364-2005\" module"), 0u);
    EXPECT_THAT(result.changes, ElementsAre("f.v:1: \"do\" is read as a name, as in Verilog-2005"));
    EXPECT_THAT(normalise("module m(input logic do);", "f.v", false).changes, IsEmpty());
    EXPECT_THAT(normalise("module m(input do);", "f.sv", true).changes, IsEmpty());
}

TEST(Normalise, GivesOpenInputsOfModelsTheirLevel) {
    const sim::project::OpenInputs open{
        {"altsyncram", "clocken0"}, {"altsyncram", "rden_b"}, {"altsyncram", "byteena_a"}};
    const auto result = normalise("altsyncram #(.W(1)) u (.clock0(c), .rden_b(), .byteena_a(b));",
                                  "f.v", false, open);
    EXPECT_THAT(result.text, HasSubstr(".clocken0(-1)"));
    EXPECT_THAT(result.text, HasSubstr(".rden_b(-1)"));
    EXPECT_THAT(result.text, HasSubstr(".byteena_a(b)"));
    EXPECT_THAT(result.changes, IsEmpty());
    for (const char* name : {"own altsyncram (.clock0(c));", "own #(.W(f(1))) altsyncram (.q(c));"})
        EXPECT_EQ(normalise(name, "f.v", false, open).text, name);
    EXPECT_THAT(
        normalise("for (i = 0; i < 2; i = i + 1) altsyncram u (.q(c));", "f.v", false, open).text,
        HasSubstr(".clocken0(-1)"));
}

TEST(Normalise, LinesStayWhereTheyAre) {
    const std::string text = "module m(a,\n);\n/* \n */ sub (.x(1'b11));\n\nendmodule\n";
    const std::string now = cleaned(text);
    EXPECT_EQ(std::count(now.begin(), now.end(), '\n'), std::count(text.begin(), text.end(), '\n'));
}

}  // namespace
