#include "sim/debug/arm_registers.h"

namespace sim {

static GdbRegisters listed() {
    constexpr const char *CORE = "org.gnu.gdb.arm.core", *VFP = "org.gnu.gdb.arm.vfp";
    // CPSR first: its mode selects the banked r13 and r14.
    GdbRegisters list{"arm", "", {}, arm_register::PC, arm_register::CPSR};
    for (unsigned n = 0; n < 13; ++n)
        list.all.push_back({CORE, "r" + std::to_string(n), 32, "uint32"});
    list.all.push_back({CORE, "sp", 32, "data_ptr"});
    list.all.push_back({CORE, "lr", 32, "int"});
    list.all.push_back({CORE, "pc", 32, "code_ptr"});
    list.all.push_back({CORE, "cpsr", 32, "int"});
    for (unsigned n = 0; n < 32; ++n)
        list.all.push_back({VFP, "d" + std::to_string(n), 64, "ieee_double"});
    list.all.push_back({VFP, "fpscr", 32, "int"});
    return list;
}

const GdbRegisters& arm_registers() {
    static const GdbRegisters list = listed();
    return list;
}

}  // namespace sim
