#include "sim/debug/nios_v_debugger.h"

#include <algorithm>
#include <iterator>

namespace sim {

namespace {

// By number: 0 - 31 x0 - x31, 32 pc, 33 - 64 f0 - f31, then CSRS.
namespace nios_v_register {
constexpr unsigned PC = 32, F0 = 33, FIRST_CSR = 65;

struct Csr {
    const char* name;
    std::uint32_t number;
};
using namespace riscv_csr;
constexpr Csr CSRS[] = {{"fflags", FFLAGS},       {"frm", FRM},
                        {"fcsr", FCSR},           {"mstatus", MSTATUS},
                        {"misa", MISA},           {"mie", MIE},
                        {"mtvec", MTVEC},         {"mscratch", MSCRATCH},
                        {"mepc", MEPC},           {"mcause", MCAUSE},
                        {"mtval", MTVAL},         {"mip", MIP},
                        {"mcycle", MCYCLE},       {"minstret", MINSTRET},
                        {"mcycleh", MCYCLEH},     {"minstreth", MINSTRETH},
                        {"mvendorid", MVENDORID}, {"marchid", MARCHID},
                        {"mimpid", MIMPID},       {"mhartid", MHARTID}};
constexpr unsigned OF_FLOATING_POINT = 3;  // of CSRS, as GDB has them
}  // namespace nios_v_register

GdbRegisters listed_registers() {
    using namespace nios_v_register;
    constexpr const char *CPU = "org.gnu.gdb.riscv.cpu", *FPU = "org.gnu.gdb.riscv.fpu",
                         *CSR = "org.gnu.gdb.riscv.csr";
    // Without "none", gdb-multiarch takes Linux, of which it knows no single steps: it would step
    // by breakpoints, which interrupts pass.
    GdbRegisters list{"riscv:rv32", "none", {}, PC, PC};
    for (unsigned n = 0; n < 32; ++n) list.all.push_back({CPU, "x" + std::to_string(n), 32, "int"});
    list.all.push_back({CPU, "pc", 32, "code_ptr"});
    for (unsigned n = 0; n < 32; ++n)
        list.all.push_back({FPU, "f" + std::to_string(n), 32, "ieee_single"});
    for (unsigned n = 0; n < std::size(CSRS); ++n)
        list.all.push_back({n < OF_FLOATING_POINT ? FPU : CSR, CSRS[n].name, 32, "int"});
    return list;
}

}  // namespace

NiosVDebugger::NiosVDebugger(NiosVCpu& cpu, GdbConnection& connection,
                             std::function<bool()> given_up)
    : Debugger{cpu, connection, std::move(given_up)}, cpu_{cpu}, core_{cpu.core()} {
    cpu_.attach(this);
}

NiosVDebugger::~NiosVDebugger() { cpu_.attach(nullptr); }

// ---- When to stop -------------------------------------------------------------------------------

bool NiosVDebugger::before(std::uint32_t pc) {
    return std::find(breaks_.begin(), breaks_.end(), pc) != breaks_.end() && reached();
}

// On the board the debugger's EBREAK is executed again; so here, if it is one no longer.
bool NiosVDebugger::on_breakpoint() {
    constexpr std::uint32_t EBREAK = 0x00100073;
    std::uint32_t word = EBREAK;
    return stops_by(gdb_signal::TRAP) ||
           (core_.read_ram(core_.pc(), &word, sizeof word) && word != EBREAK);
}

bool NiosVDebugger::on_failure(std::uint32_t cause) {
    using namespace riscv_cause;
    switch (cause) {
        case FETCH_MISALIGNED:
        case LOAD_MISALIGNED:
        case STORE_MISALIGNED: return stops_by(gdb_signal::BUS);
        case ILLEGAL: return stops_by(gdb_signal::ILL);
        case BREAKPOINT: return stops_by(gdb_signal::TRAP);
        case ECALL: return stops_by(gdb_signal::SYS);
        default: return stops_by(gdb_signal::SEGV);
    }
}

void NiosVDebugger::observe(const std::vector<std::uint32_t>& breaks, bool accesses) {
    breaks_ = breaks;
    accesses_ = accesses;
    core_.attach(breaks.empty() && !accesses ? nullptr : static_cast<RiscvProbe*>(this));
}

// ---- What the debugger sees and changes ---------------------------------------------------------

const GdbRegisters& NiosVDebugger::registers() const {
    static const GdbRegisters list = listed_registers();
    return list;
}

std::uint64_t NiosVDebugger::reg(unsigned number) {
    using namespace nios_v_register;
    if (number < PC) return core_.reg(number);
    if (number == PC) return core_.pc();
    if (number < FIRST_CSR) return core_.float_reg(number - F0);
    return core_.csr(CSRS[number - FIRST_CSR].number).value();
}

// Not what a CSR has already: it may be one that cannot be written.
bool NiosVDebugger::set_reg(unsigned number, std::uint64_t value) {
    using namespace nios_v_register;
    const auto word = static_cast<std::uint32_t>(value);
    if (number < PC)
        core_.set_reg(number, word);
    else if (number == PC)
        core_.set_pc(word);
    else if (number < FIRST_CSR)
        core_.set_float_reg(number - F0, word);
    else
        return reg(number) == word || core_.set_csr(CSRS[number - FIRST_CSR].number, word);
    return true;
}

}  // namespace sim
