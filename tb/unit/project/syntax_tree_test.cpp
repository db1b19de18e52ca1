// Verilator's JSON, read as its XML is.
#include "sim/project/syntax_tree.h"

#include <string>

#include <gtest/gtest.h>

#include "sim/project/elaborated.h"
#include "sim/project/settings.h"
#include "tb/support/temp_folder.h"

namespace {

using namespace sim::project;
using sim::Direction;

// As Verilator 5.048 writes it, without what nobody reads.
constexpr const char* META = R"~({"files": {"e": {"filename": "top.v"},
  "f": {"filename": "data/rtl/ip/sub.v"}}})~";
constexpr const char* TREE = R"~({"type": "NETLIST", "modulesp": [
  {"type": "MODULE", "name": "top", "addr": "(A)", "loc": "e,1:8,1:11", "origName": "top",
   "stmtsp": [
    {"type": "VAR", "name": "clk", "addr": "(B)", "loc": "e,1:20,1:23", "dtypep": "(T)",
     "origName": "clk", "direction": "INPUT", "varType": "PORT"},
    {"type": "VAR", "name": "q", "addr": "(C)", "loc": "e,1:30,1:31", "dtypep": "(U)",
     "origName": "q", "direction": "OUTPUT", "varType": "PORT"},
    {"type": "ALWAYS", "loc": "e,2:1,2:2", "keyword": "cont_assign", "sentreep": [], "stmtsp": [
     {"type": "ASSIGNW", "loc": "e,2:1,2:2", "dtypep": "(U)",
      "rhsp": [{"type": "SEL", "loc": "e,2:5,2:6", "dtypep": "(T)", "widthConst": 4,
                "fromp": [{"type": "VARREF", "name": "clk", "dtypep": "(T)"}],
                "lsbp": [{"type": "CONST", "name": "3'h1"}]}],
      "lhsp": [{"type": "VARREF", "name": "q", "dtypep": "(U)"}]}]},
    {"type": "GENBLOCK", "name": "g", "loc": "e,3:1,3:2", "itemsp": [
     {"type": "CELL", "name": "s", "origName": "s", "loc": "e,4:1,4:2", "modp": "(D)", "pinsp": [
      {"type": "PIN", "name": "a", "loc": "e,4:5,4:6", "modVarp": "(E)", "exprp": [
       {"type": "VARREF", "name": "clk", "dtypep": "(T)"}]}]}]},
    {"type": "INITIAL", "loc": "e,5:1,5:2", "stmtsp": [
     {"type": "IF", "loc": "e,5:3,5:4", "condp": [{"type": "CONST", "name": "1'h1"}],
      "thensp": [{"type": "ASSIGN", "loc": "e,5:5,5:6"}], "elsesp": []},
     {"type": "LOOP", "loc": "e,6:1,6:2", "stmtsp": [
      {"type": "LOOPTEST", "loc": "e,6:3,6:4", "condp": [{"type": "CONST", "name": "1'h0"}]},
      {"type": "ASSIGN", "loc": "e,6:5,6:6"}], "contsp": [{"type": "ASSIGN", "loc": "e,6:7,6:8"}]}
    ]}]},
  {"type": "MODULE", "name": "sub__1", "addr": "(D)", "loc": "f,9:8,9:11", "origName": "sub",
   "stmtsp": [
    {"type": "VAR", "name": "INIT_FILE", "addr": "(F)", "loc": "e,9:9,9:9", "dtypep": "(U)",
     "origName": "INIT_FILE", "direction": "NONE", "varType": "GPARAM",
     "valuep": [{"type": "CONST", "name": "48'h612e686578"}]},
    {"type": "VAR", "name": "a", "addr": "(E)", "loc": "e,9:9,9:9", "dtypep": "(T)",
     "origName": "a", "direction": "INPUT", "varType": "PORT"}]}],
 "miscsp": [{"type": "TYPETABLE", "typesp": [
  {"type": "BASICDTYPE", "name": "logic", "addr": "(T)", "dtypep": "(T)", "keyword": "logic"},
  {"type": "BASICDTYPE", "name": "logic", "addr": "(U)", "dtypep": "(U)", "keyword": "logic",
   "range": "0:3", "signed": true}]}]})~";

class SyntaxTree : public ::testing::Test {
protected:
    TempFolder folder;
    const std::filesystem::path file = folder / "design.json";

    void SetUp() override {
        folder.put("design.json", TREE);
        folder.put(std::filesystem::path{tree_meta(file.string())}.filename(), META);
    }
};

TEST_F(SyntaxTree, OfJsonHasThePortsAndInitFiles) {
    const Elaborated design = read_elaborated(file, "top");
    ASSERT_EQ(design.ports.size(), 2u);
    EXPECT_EQ(design.ports[0].name, "clk");
    EXPECT_FALSE(design.ports[0].vector);
    EXPECT_EQ(design.ports[1].direction, Direction::OUTPUT);
    EXPECT_EQ(design.ports[1].left, 0);
    EXPECT_EQ(design.ports[1].right, 3);
    ASSERT_EQ(design.init_files.size(), 1u);
    EXPECT_EQ(design.init_files[0].name, "a.hex");
    EXPECT_EQ(design.init_files[0].place, "top.v:4");
}

TEST_F(SyntaxTree, OfJsonHasTheFormOfXml) {
    const pugi::xml_document tree = syntax_tree(file);
    const auto has = [&](const char* path) { return !tree.select_nodes(path).empty(); };
    for (const char* path :
         {"//module[@origName='top' and @topModule='1']/contassign[@loc='e,2,1,2,2']/sel/const[2]"
          "[@name=\"32'h4\"]",
          "//module/begin[@name='g']/instance[@defName='sub__1']/port[@direction='in']/varref",
          "//initial/if/const", "//initial/if/begin[assign]", "//initial/while/begin[1][not(*)]",
          "//initial/while/begin[2]/const", "//initial/while/begin[3]/assign",
          "//initial/while/begin[4]/assign", "//var[@name='INIT_FILE' and @param='true']",
          "//typetable/basicdtype[@id='(U)' and @signed='true' and @left='0' and @right='3']"})
        EXPECT_TRUE(has(path)) << path;
    EXPECT_FALSE(has("//if/begin[2]")) << "there is no else";
    EXPECT_FALSE(has("//looptest"));
}

TEST_F(SyntaxTree, OfAFileThatEndsTooEarlyIsRefused) {
    folder.put("design.json", std::string{TREE}.substr(0, 300));
    EXPECT_THROW(syntax_tree(file), ProjectError);
}

}  // namespace
