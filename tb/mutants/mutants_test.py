"""mutants_test.py - faults, their ids, and the list of equivalents, on a small Verilog text."""
import threading
import types
import unittest

from equivalents import Stale, equivalents, killed_after_all
from faults import constants, faults_of
from judge import Judge
from mutants import summary

TEXT = """// small.v - a == b, "if (x)" and 4'd3 in a comment
`include "regmap.vh"
`define LIMIT (3 + 4)
module small #(parameter WIDTH = 4 + 4) (
    input  wire [WIDTH-1:0] a_i,   // a && b
    output reg  [7:0]       b_o,
    output wire             awake_o
);
    /* a | b
       a & b */
    wire c = a_i == 4'd3 && !(b_o <= 2);  // <= compares here
    assign awake_o = c || b_o != 8'd0;
    always @(posedge clk_i) begin
        if (c) b_o <= c ? a_i[6:4] : ~b_o;
        $display("a == b ? 1 : 2");
        if (rst_i) b_o <= 8'h0f;
    end
endmodule
"""


def found(text, constants=()):
    return {fault.what for fault in faults_of("x.v", f"module x;\n{text}\nendmodule\n", constants)}


class Faults(unittest.TestCase):
    def test_each_operator_gives_its_faults(self):
        for operator, faults in {
                "+": {"+ -> -"}, "-": {"- -> +"}, "&": {"& -> |"}, "|": {"| -> &"},
                "&&": {"&& -> ||"}, "||": {"|| -> &&"}, "==": {"== -> !="}, "!=": {"!= -> =="},
                "<": {"< -> <="}, "<=": {"<= -> <"}, ">": {"> -> >="}, ">=": {">= -> >"},
                "^": set(), "<<": set(), "===": set()}.items():
            self.assertEqual(found(f"wire a = b {operator} c;"), faults, operator)

    def test_a_sign_or_a_reduction_is_not_an_operator_of_two(self):
        self.assertEqual(found("wire a = -b; wire d = &b; wire e = |{b, c};"), set())

    def test_negations_are_dropped(self):
        self.assertEqual(found("wire a = !b;"), {"! dropped"})
        self.assertEqual(found("wire a = ~b;"), {"~ dropped"})
        self.assertEqual(found("wire a = ~|b;"), {"~ dropped"})

    def test_a_number_becomes_one_more_or_loses_its_highest_bit(self):
        self.assertEqual(constants("8'hff"), ["8'h00", "8'h7f"])
        self.assertEqual(constants("6'd24"), ["6'd25", "6'd56"])
        self.assertEqual(constants("1'b0"), ["1'b1"])
        self.assertEqual(constants("640"), ["641", "128"])
        self.assertEqual(constants("0"), ["1"])
        self.assertEqual(constants("4'b1x0?"), [])

    def test_a_condition_is_negated_true_or_false(self):
        self.assertEqual(found("always @* if (b) a = c;"),
                         {"if (x) -> if (!x)", "if (x) -> if (1'b1)", "if (x) -> if (1'b0)",
                          "a = left out"})
        self.assertNotIn("if (x) -> if (!x)", found("always @* if (!b) a = c;"))

    def test_the_arms_of_a_condition_are_swapped(self):
        text = "module x;\nassign a = b ? f(c, d) : e ? g : h;\nendmodule\n"
        swapped = [fault.apply(text).splitlines()[1] for fault in faults_of("x.v", text)
                   if fault.kind == "arms"]
        self.assertEqual(swapped, ["assign a = b ? (e ? g : h) : (f(c, d));",
                                   "assign a = b ? f(c, d) : e ? (h) : (g);"])
        self.assertEqual(found("wire a = b ? c : c;"), set())

    def test_a_range_loses_a_bit_but_a_declaration_only_its_highest(self):
        self.assertEqual(found("wire a = b[6:4];"), {"high bit 6 -> 5", "low bit 4 -> 5"})
        self.assertEqual(found("reg [7:0] a;"), {"high bit 7 -> 6"})
        self.assertEqual(found("wire a = b[3];"), {"3 -> 4", "3 -> 1"})

    def test_a_constant_does_not_lose_a_highest_bit_that_is_0(self):
        high = "high bit 3 -> 2"
        for text, value, is_fault in (("wire a = b == C[3:0];", 7, False),
                                      ("wire a = b == C[3:0];", 8, True),
                                      ("wire a = {b, C[3:0]};", 7, True),
                                      ("wire a = {b == f(C[3:0])};", 7, True)):
            self.assertEqual(high in found(text, {"C": value}), is_fault, text)
        self.assertIn(high, found("wire a = b == C[3:0];"))
        self.assertNotIn(high, found("localparam [3:0] C = 4'd7;"))
        self.assertIn(high, found("localparam [3:0] C = 4'b1000;"))
        self.assertIn(high, found("localparam [3:0] C = 4'd7, D = 4'd8;"))
        self.assertIn(high, found("localparam [3:0] C = 4'd7; wire a = {2{C}};"))

    def test_statements_are_left_out_declarations_are_not(self):
        self.assertEqual(found("always @* begin {a, b[c]} = d; case (e) f: g <= h; endcase end"),
                         {"{ = left out", "g <= left out"})
        self.assertEqual(found("wire a = b; localparam C = D; reg e = f;"), set())

    def test_what_wakes_is_left_out_cause_by_cause(self):
        self.assertEqual({what for what in found("assign awake_o = a || |b || f(c, d);")
                          if what.startswith("wakes")},
                         {"wakes without a", "wakes without |b", "wakes without f(c, d)"})

    def test_values_of_a_reset_are_a_kind_of_their_own(self):
        kinds = {fault.what: fault.kind for fault in faults_of("small.v", TEXT)}
        self.assertEqual(kinds["8'h0f -> 8'h10"], "reset")
        self.assertEqual(kinds["8'd0 -> 8'd1"], "constant")

    def test_a_file_has_these_faults_and_none_in_comments_strings_headers_and_directives(self):
        ids = [fault.id for fault in faults_of("small.v", TEXT)]
        self.assertEqual(ids, [
            "small.v:11:18:== -> !=", "small.v:11:21:4'd3 -> 4'd11", "small.v:11:21:4'd3 -> 4'd4",
            "small.v:11:26:&& -> ||", "small.v:11:29:! dropped", "small.v:11:35:<= -> <",
            "small.v:11:38:2 -> 0", "small.v:11:38:2 -> 3",
            "small.v:12:5:awake_o = left out", "small.v:12:22:wakes without c",
            "small.v:12:24:|| -> &&", "small.v:12:27:wakes without b_o != 8'd0",
            "small.v:12:31:!= -> ==", "small.v:12:34:8'd0 -> 8'd1",
            "small.v:12:34:8'd0 -> 8'd128",
            "small.v:14:9:if (x) -> if (!x)", "small.v:14:9:if (x) -> if (1'b0)",
            "small.v:14:9:if (x) -> if (1'b1)", "small.v:14:16:b_o <= left out",
            "small.v:14:25:arms of ?: swapped", "small.v:14:31:high bit 6 -> 5",
            "small.v:14:33:low bit 4 -> 5", "small.v:14:38:~ dropped",
            "small.v:16:9:if (x) -> if (!x)", "small.v:16:9:if (x) -> if (1'b0)",
            "small.v:16:9:if (x) -> if (1'b1)", "small.v:16:20:b_o <= left out",
            "small.v:16:27:8'h0f -> 8'h10", "small.v:16:27:8'h0f -> 8'h8f"])

    def test_a_fault_changes_its_place_only_and_ids_are_found_again(self):
        again = {fault.id: fault for fault in faults_of("small.v", TEXT)}
        self.assertEqual(len(again), len(faults_of("small.v", TEXT)))
        for fault in faults_of("small.v", TEXT):
            before, after = TEXT.splitlines(), again[fault.id].apply(TEXT).splitlines()
            self.assertEqual([number for number, line in enumerate(before, 1)
                              if line != after[number - 1]], [fault.line], fault.id)


class Equivalents(unittest.TestCase):
    def setUp(self):
        self.entry = "small.v :: || -> && :: assign awake_o = c || b_o != 8'd0; :: because"

    def test_an_entry_names_its_fault_wherever_the_line_is(self):
        for text in (TEXT, "\n\n" + TEXT):
            text_of_it, reason = self.entry.rsplit(" :: ", 1)
            fault, = equivalents(["# comment", "", text_of_it, "    :: " + reason],
                                 faults_of("small.v", text))
            self.assertRegex(fault, r"^small\.v:1[24]:24:\|\| -> &&$")

    def test_an_entry_whose_text_is_gone_is_stale(self):
        with self.assertRaisesRegex(Stale, "equivalent.txt:1: stale"):
            equivalents([self.entry], faults_of("small.v", TEXT.replace("8'd0;", "8'd1;")))

    def test_an_entry_without_a_reason_or_for_two_faults_is_refused(self):
        with self.assertRaisesRegex(Stale, "not FILE"):
            equivalents([self.entry[:-len(" :: because")]], faults_of("small.v", TEXT))
        faults = faults_of("small.v", "module x;\nwire a = b + c + d;\nendmodule\n")
        entry = "small.v :: + -> -{} :: wire a = b + c + d; :: because"
        with self.assertRaisesRegex(Stale, "names 2 faults"):
            equivalents([entry.format("")], faults)
        self.assertEqual(list(equivalents([entry.format(" #2")], faults)), [faults[1].id])

    def test_an_equivalent_that_is_found_after_all_is_stale_and_others_are_not_counted(self):
        result = {"id": "a", "kind": "operator", "text": "", "by": "pio_test", "undecided": []}
        results = [{**result, "layer": "block", "equivalent": "because"},
                   {**result, "layer": None, "equivalent": "because"},
                   {**result, "layer": "invalid", "equivalent": None},
                   {**result, "layer": "block", "equivalent": None},
                   {**result, "layer": "proofs", "equivalent": None},
                   {**result, "layer": "whole", "equivalent": None},
                   {**result, "layer": None, "equivalent": None}]
        self.assertEqual(len(killed_after_all(results)), 1)
        lines, rates = summary(results)
        self.assertEqual(rates, {"block": 25, "proofs": 50, "whole": 75})
        self.assertEqual(sum(line.startswith("survives: a") for line in lines), 1)


class FakeTree:
    """A tree whose tests answer as told while the mutant is in it."""

    def __init__(self, **answers):
        self.answers, self.file, self.tried = answers, TEXT, []

    def put(self, file, text):
        self.file = text

    def lint(self, file):
        return self.answers.get("lint")

    def tests_of(self, layer, file, seconds):
        return [types.SimpleNamespace(name=layer, layer=layer)]

    def try_test(self, test, limit):
        if self.file == TEXT:
            return self.answers.get("unchanged", "passes"), 1
        self.tried.append(test.name)
        return self.answers.get(test.name, "passes"), 1


class Judging(unittest.TestCase):
    def judged(self, **answers):
        self.tree = FakeTree(**answers)
        judge = Judge(self.tree, {}, 60, threading.Event())
        result = judge(faults_of("small.v", TEXT)[0], TEXT)
        self.assertEqual(self.tree.file, TEXT)  # restored
        return result

    def test_the_first_layer_that_finds_it_ends_it(self):
        self.assertEqual(self.judged(proofs="fails")[:2], ("proofs", "proofs"))
        self.assertEqual(self.tree.tried, ["block", "proofs"])
        self.assertEqual(self.judged(whole="fails")[:2], ("whole", "whole"))

    def test_one_that_no_layer_finds_survives(self):
        self.assertIsNone(self.judged()[0])
        self.assertEqual(self.tree.tried, ["block", "proofs", "whole"])

    def test_a_test_that_hangs_has_found_it_a_proof_has_not(self):
        self.assertEqual(self.judged(block="hangs")[0], "block")
        self.assertEqual(self.judged(proofs="hangs"), (None, "", "", ["proofs"]))

    def test_what_is_not_verilog_is_no_mutant(self):
        self.assertEqual(self.judged(lint="syntax error")[0], "invalid")
        self.assertEqual(self.judged(block="does not build")[0], "invalid")

    def test_a_test_that_fails_without_the_fault_ends_all(self):
        with self.assertRaisesRegex(SystemExit, "block fails without a fault"):
            self.judged(unchanged="fails")


if __name__ == "__main__":
    unittest.main()
