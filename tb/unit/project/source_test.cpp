// Verilog as tokens, and what is found in it without elaborating it.
#include "sim/verilog/source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/verilog/tokens.h"

namespace {

using sim::project::scan;
using sim::project::Tokens;
using sim::project::tokens_of;
using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

std::string joined(const Tokens& tokens) {
    std::string text;
    for (const auto& token : tokens.all) {
        text += token.gap;
        text += token.text;
    }
    return text.append(tokens.tail);
}

TEST(Tokens, JoinedAreTheFile) {
    const std::string text =
        "`define A(x) \\\n  x + 1\n/* c */ module \\esc[0] (a); // d\n"
        "  assign s = 8 'h F0 + \"/* no \\\" comment\"; `A(1)\n`ifdef X y `else z "
        "`endif\nendmodule";
    EXPECT_EQ(joined(tokens_of(text)), text);
    std::string bytes;
    for (int i = 0; i < 4096; ++i) bytes += static_cast<char>(i * 101);
    EXPECT_EQ(joined(tokens_of(bytes)), bytes);
}

TEST(Tokens, KnowTheirLine) {
    const std::string text = "a\n/* \n */ b `timescale 1ns/1ps\nc";
    const auto tokens = tokens_of(text).all;
    ASSERT_EQ(tokens.size(), 3u);
    EXPECT_EQ(tokens[0].line, 1u);
    EXPECT_EQ(tokens[1].line, 3u);
    EXPECT_EQ(tokens[2].line, 4u);
}

TEST(Tokens, NumbersHaveTheirSize) {
    const auto tokens = tokens_of("12'h_ab + 4 'b 01?z - 3.5e2").all;
    ASSERT_EQ(tokens.size(), 5u);
    EXPECT_EQ(tokens[0].text, "12'h_ab");
    EXPECT_EQ(tokens[2].text, "4 'b 01?z");
}

TEST(Scan, KnowsTheDirectionsAndThePlacesOfPorts) {
    const auto source = scan(
        "module a #(parameter W = 8) (input [W-1:0] x, inout p, q, output reg [3:0] r = 0);\n"
        "endmodule module b(m, n, o); inout [1:0] o; input m; output n; endmodule");
    ASSERT_EQ(source.modules.size(), 2u);
    EXPECT_THAT(source.modules[0].header, ElementsAre("x", "p", "q", "r"));
    EXPECT_THAT(source.modules[0].inouts, ElementsAre("p", "q"));
    EXPECT_THAT(source.modules[0].outputs, ElementsAre("r"));
    EXPECT_THAT(source.modules[1].header, ElementsAre("m", "n", "o"));
    EXPECT_THAT(source.modules[1].inouts, ElementsAre("o"));
    EXPECT_THAT(source.modules[1].outputs, ElementsAre("n"));
}

TEST(Scan, FindsModulesPortsAndInstances) {
    const auto source = scan(R"(
        module top #(parameter W = 8) (input clk, input wire [W-1:0] a, b, output reg q);
            wire x;
            adder #(.W(W)) first (.a(a), .b(b));
            // comment u (a);
            ram second [3:0] (clk);
            always @(posedge clk) if (x) q <= f(a); else begin q <= 1; end
            function f; input i; f = i; endfunction
            unnamed (.a(x));
        endmodule
        module old (c, d); input c; output [3:0] d; endmodule)");
    ASSERT_EQ(source.modules.size(), 2u);
    EXPECT_EQ(source.modules[0].name, "top");
    EXPECT_THAT(source.modules[0].wants, UnorderedElementsAre("adder", "ram", "unnamed"));
    EXPECT_THAT(source.modules[0].ports, ::testing::IsSupersetOf({"clk", "a", "b", "q"}));
    EXPECT_THAT(source.modules[1].ports, ElementsAre("c", "d"));
}

TEST(Scan, FindsPackagesAndTheirUse) {
    const auto source = scan("package p; endpackage module m; import p::*; other::t x; endmodule");
    EXPECT_TRUE(source.modules[0].is_package);
    EXPECT_THAT(source.packages, UnorderedElementsAre("p", "other"));
}

TEST(Scan, FindsInstancesWithoutANameButNoTasks) {
    const auto text = scan(
        "module m; always @(posedge c) begin clear(x); end "
        "sub (x, y); ram #(2) (.q(y)); endmodule");
    EXPECT_THAT(text.modules.at(0).wants, UnorderedElementsAre("sub", "ram"));
}

}  // namespace
