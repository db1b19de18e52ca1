// Whether a model's eval_act() is empty, so that verilated/evaluate.h may leave it out.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "sim/project/tools.h"
#include "tb/support/temp_folder.h"

namespace {

namespace fs = std::filesystem;
using sim::project::has_empty_act;

const char* const EMPTY =
    "#include \"Vx.h\"\n"
    "\n"
    "VL_INLINE_OPT void Vx___024root___ico(Vx___024root* vlSelf) {\n"
    "    vlSelf->a = vlSelf->b;\n"
    "}\n"
    "\n"
    "void Vx___024root___eval_act(Vx___024root* vlSelf) {\n"
    "    if (false && vlSelf) {}  // Prevent unused\n"
    "    Vx__Syms* const __restrict vlSymsp VL_ATTR_UNUSED = vlSelf->vlSymsp;\n"
    "    VL_DEBUG_IF(VL_DBG_MSGF(\"+    Vx___024root___eval_act\\n\"); );\n"
    "}\n";

bool has_empty_act_in(const std::string& text) {
    const TempFolder folder;
    folder.put("Vx.cpp", text);
    return has_empty_act(folder / "Vx.cpp", "Vx");
}

TEST(EmptyAct, HasOnlyTheLinesThatEachModelHas) { EXPECT_TRUE(has_empty_act_in(EMPTY)); }

TEST(EmptyAct, HasNoStatement) {
    std::string text = EMPTY;
    text.insert(text.rfind('}'), "    Vx___024root___act_comb__TOP__0(vlSelf);\n");
    EXPECT_FALSE(has_empty_act_in(text));
}

TEST(EmptyAct, IsNotInAFileWithoutTheFunction) {
    std::string text = EMPTY;
    text.replace(text.find("eval_act"), 8, "eval_nba");
    EXPECT_FALSE(has_empty_act_in(text));
}

// fabric_model.h leaves it out without a look.
TEST(EmptyAct, IsThatOfOurOwnFpga) {
    if (std::string{VERILATOR_VERSION} != "5.006") GTEST_SKIP() << "of Verilator 5.006 alone";
    bool any = false;
    for (const auto& entry : fs::directory_iterator{FABRIC_MODEL})
        any |= entry.path().extension() == ".cpp" && has_empty_act(entry.path(), "Vfpga");
    EXPECT_TRUE(any) << "in " << FABRIC_MODEL;
}

}  // namespace
