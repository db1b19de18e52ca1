// NiosVCpu with its timer, memory and a probe where the FPGA would be: programs of a few words.
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/chip/nios_v_devices.h"
#include "sim/cpu/nios_v_cpu.h"
#include "sim/hps/bus.h"
#include "sim/hps/memory.h"
#include "tb/sim/probe.h"
#include "tb/sim/riscv_core/encodings.h"

namespace tb::riscv {

using namespace sim;
using namespace riscv_csr;
using sc_core::sc_time;
using testing::ElementsAre;
using testing::HasSubstr;
using Words = std::vector<std::uint32_t>;

namespace {

constexpr std::uint32_t PROBE = 0xFF200000, TIMER = 0xFF202100, HANDLER = 0x1000;

NiosVProgram program_of(const Words& words, const Words& handler) {
    NiosVProgram program;
    const auto add = [&](std::uint32_t address, const Words& code) {
        const auto size = static_cast<std::uint32_t>(code.size() * 4);
        std::vector<std::uint8_t> bytes(size);
        if (size) std::memcpy(bytes.data(), code.data(), size);
        program.elf.segments.push_back({address, address, size, std::move(bytes), true, true});
    };
    add(0, words);
    add(HANDLER, handler);
    return program;
}

}  // namespace

struct NiosVSystem : sc_core::sc_module {
    std::vector<std::string> log;
    Memory sdram{"sdram", 0x4000000, sc_core::SC_ZERO_TIME};
    Probe probe{"probe"};
    Bus bus{"bus"};
    NiosVWindow window{"window"};
    NiosVCpu cpu;
    MachineTimer timer{"timer", [this](std::uint32_t lines) { cpu.set_lines(lines); }};

    NiosVSystem(const sc_core::sc_module_name& name_, NiosVProgram program)
        : sc_module{name_}, cpu{"cpu", std::move(program), [this](const std::string& line) {
                                    log.push_back(line);
                                }} {
        cpu.socket.bind(bus.socket);
        bus.window("sdram", 0, 0x4000000).bind(sdram.socket);
        bus.window("registers", PROBE, 0x200000).bind(window.socket);
        window.fpga.bind(probe.socket);
        window.timer.bind(timer.socket);
        cpu.explain_by([this](auto... access) { return bus.refusal(access...); });
    }
};

class NiosV : public testing::Test {
protected:
    void run(const Words& words, const Words& handler = {}, double ms = 1) {
        NiosVProgram program = program_of(words, handler);
        program.elf.sections = sections;
        system = std::make_unique<NiosVSystem>("system", std::move(program));
        sc_core::sc_start(sc_time{ms, sc_core::SC_MS});
    }
    NiosVCpu& cpu() { return system->cpu; }
    std::string fault() { return cpu().fault().value_or("none"); }

    static Words with_handler(const Words& words) {
        return joined({li(5, HANDLER), {csrrw(0, MTVEC, 5)}, words});
    }
    // Enables these interrupts.
    static Words enabled(std::uint32_t lines) {
        return joined({li(5, lines), {csrrw(0, MIE, 5), addi(5, 0, 8), csrrs(0, MSTATUS, 5)}});
    }

    std::vector<ElfSection> sections;
    std::unique_ptr<NiosVSystem> system;
};

TEST_F(NiosV, FailsByATrapForWhichItHasNoHandler) {
    run(joined({li(1, 0x80000000), {lw(2, 1, 0)}}));
    EXPECT_THAT(fault(), HasSubstr("access fault: load at 0x80000000"));
    EXPECT_THAT(fault(), HasSubstr("it has no handler: mtvec was never written"));
}

TEST_F(NiosV, FailsWhereItRunsOffItsCodeIntoZeros) {
    run({NOP, NOP});
    EXPECT_THAT(fault(), HasSubstr("the program ran off its code into zeros"));
    EXPECT_THAT(fault(), HasSubstr("PC 0x00000008"));
}

TEST_F(NiosV, FailsByAJumpToWhereNoMemoryIs) {
    run(joined({li(1, 0x40000000), {jalr(1, 1)}}));
    EXPECT_THAT(fault(), HasSubstr("no instruction to be read at 0x40000000"));
}

TEST_F(NiosV, FailsByAnUnalignedAccess) {
    run({addi(1, 0, 0x101), lw(2, 1, 0)});
    EXPECT_THAT(fault(), HasSubstr("load at 0x00000101 is not aligned"));
}

TEST_F(NiosV, FailsByACompressedInstructionAndSaysSo) {
    run({0x00010001});
    EXPECT_THAT(fault(), HasSubstr("a compressed one, which Nios V does not have"));
}

TEST_F(NiosV, FailsWhereItsHandlerReturnsToTheSameFaultForEver) {
    run(with_handler(joined({li(1, 0x80000000), {lw(2, 1, 0)}})), {MRET});
    EXPECT_THAT(fault(), HasSubstr("to which its handler has returned 1000 times"));
}

TEST_F(NiosV, FailsWhereItsHandlerTrapsAtItsFirstInstruction) {
    run(with_handler({0xFFFFFFFF}), {0xFFFFFFFF});
    EXPECT_THAT(fault(), HasSubstr("at the first instruction of its own handler"));
}

TEST_F(NiosV, FailsWhereItsHandlerOfAnExceptionLoopsForEver) {
    run(with_handler({0xFFFFFFFF}), {jump(0)}, 150);
    EXPECT_THAT(fault(), HasSubstr("illegal instruction 0xFFFFFFFF"));
    EXPECT_THAT(fault(), HasSubstr("its handler loops for ever"));
}

TEST_F(NiosV, FailsByAnInterruptForWhichItHasNoHandler) {
    run(joined({enabled(1 << 3), li(1, TIMER), {addi(2, 0, 1), sw(2, 1, 16), jump(0)}}));
    EXPECT_THAT(fault(), HasSubstr("interrupt 3 came"));
    EXPECT_THAT(fault(), HasSubstr("it has no handler: mtvec was never written"));
}

TEST_F(NiosV, FailsWhereMtvecLeadsToZeros) {
    run(joined({li(5, 0x2000), {csrrw(0, MTVEC, 5), 0xFFFFFFFF}}));
    EXPECT_THAT(fault(), HasSubstr("mtvec (0x00002000) leads to 0x00002000, where there are only "
                                   "zeros"));
}

TEST_F(NiosV, FailsWhereTheVectorOfAnInterruptLeadsToZeros) {
    const Words raise = joined({li(1, TIMER), {addi(2, 0, 1), sw(2, 1, 16), jump(0)}});
    run(joined({li(5, 0x2001), {csrrw(0, MTVEC, 5)}, enabled(1 << 3), raise}));
    EXPECT_THAT(fault(), HasSubstr("mtvec (0x00002001) leads to 0x0000200C, where there are only "
                                   "zeros"));
}

TEST_F(NiosV, FailsWhereMtvecLeadsToData) {
    sections = {{0x1000, 0x1000, ".data", true, false}};
    run(with_handler({0xFFFFFFFF}), {0xFFFFFFFF});
    EXPECT_THAT(fault(), HasSubstr("leads to 0x00001000, which is data (.data)"));
}

TEST_F(NiosV, FailsByATrapInItsData) {
    sections = {{0x2000, 0x1000, ".data", true, false}};
    run(with_handler(joined({li(1, 0x2000), {jalr(0, 1)}})), {jump(0)});
    EXPECT_THAT(fault(), HasSubstr("; the program has gone into its data, .data"));
}

TEST_F(NiosV, SaysThatItsStackPointerWasNeverSet) {
    run({addi(2, 2, -16), sw(1, 2, 12), jump(0)});
    EXPECT_THAT(fault(), HasSubstr("store at 0xFFFFFFFC"));
    EXPECT_THAT(fault(), HasSubstr("SP is 0xFFFFFFF0: it was never set"));
}

TEST_F(NiosV, FailsWhereItsStackGrowsIntoItsCode) {
    sections = {{0x1000, 0xF000, ".text", false, true}};
    run(joined({li(2, 0x20000), {addi(2, 2, -16), sw(0, 2, 0), jump(-8)}}), {NOP}, 20);
    EXPECT_THAT(fault(), HasSubstr("the program ran out of stack"));
    EXPECT_THAT(fault(), HasSubstr("the stack has grown into the program's code (SP 0x"));
}

TEST_F(NiosV, GoesOnAfterAnExceptionThatItsHandlerPasses) {
    const Words skip{csrrs(6, MEPC, 0), addi(6, 6, 4), csrrw(0, MEPC, 6), MRET};
    run(with_handler(joined({{0xFFFFFFFF}, li(1, PROBE), {sw(1, 1, 0), jump(0)}})), skip);
    EXPECT_EQ(fault(), "none");
    EXPECT_EQ(system->probe.values[0], PROBE);
    ASSERT_EQ(system->log.size(), 1u);
    EXPECT_THAT(system->log[0], HasSubstr("illegal instruction 0xFFFFFFFF"));
}

TEST_F(NiosV, HasEndedWhereItLoopsWithInterruptsMasked) {
    run({NOP, jump(0)});
    EXPECT_GT(cpu().ended_for(), sc_time(500, sc_core::SC_US));
}

TEST_F(NiosV, HasNotEndedWhereItLoopsForAnInterrupt) {
    run(joined({with_handler(enabled(1 << 7)), {jump(0)}}));
    EXPECT_EQ(cpu().ended_for(), sc_core::SC_ZERO_TIME);
}

// The board's debugger, which loads each program, takes EBREAK (Nios V Processor Reference Manual,
// "Debug Mode"); exit() of the courses' newlib is one in a loop.
TEST_F(NiosV, EndsByAnEbreakThoughItHasAHandler) {
    run(with_handler({addi(3, 0, 1), EBREAK, jump(-4)}), {addi(3, 0, 2), MRET});
    EXPECT_EQ(fault(), "none");
    EXPECT_TRUE(cpu().position().ended);
    EXPECT_EQ(cpu().core().reg(3), 1u);
}

TEST_F(NiosV, EndsByTheEnvironmentCallOfNewlibsExit) {
    run({addi(17, 0, 93), addi(10, 0, 3), ECALL});
    EXPECT_EQ(fault(), "none");
    EXPECT_EQ(cpu().exit_code(), 3);
    EXPECT_TRUE(cpu().position().ended);
}

TEST_F(NiosV, TakesTenNanosecondsPerSimpleInstruction) {
    run(joined({li(1, PROBE), {NOP, NOP, NOP, sw(1, 1, 0), jump(0)}}));
    ASSERT_EQ(system->probe.writes.size(), 1u);
    EXPECT_EQ(system->probe.writes[0].second, sc_time(50 + 10, sc_core::SC_NS));  // the probe's 10
}

TEST_F(NiosV, ReadsItsTimeInMcycle) {
    run(joined({li(1, PROBE), {sw(1, 1, 0), csrrs(2, MCYCLE, 0), sw(2, 1, 4), jump(0)}}));
    EXPECT_EQ(system->probe.values[4], 4u);  // three instructions, and the probe's 10 ns
}

// ---- The machine timer --------------------------------------------------------------------------

TEST_F(NiosV, SleepsUntilTheTimeOfItsTimer) {
    const Words set = joined({li(1, TIMER), {sw(0, 1, 12)}, li(2, 5000), {sw(2, 1, 8)}});
    const Words handler = joined({li(1, PROBE), {sw(1, 1, 0), jump(0)}});
    run(joined({with_handler(set), enabled(1 << 7), {WFI, jump(-4)}}), handler);
    ASSERT_EQ(system->probe.writes.size(), 1u);
    EXPECT_EQ(cpu().core().csr(MCAUSE), riscv_cause::INTERRUPT | 7);
    EXPECT_EQ(system->probe.writes[0].second, sc_time(50'000 + 20 + 10, sc_core::SC_NS));
    EXPECT_EQ(cpu().counts().interrupts, 1u);
}

TEST_F(NiosV, TakesTheSoftwareInterruptAtOnce) {
    const Words raise = joined({li(1, TIMER), {addi(2, 0, 1), sw(2, 1, 16), addi(3, 0, 1)}});
    run(joined({with_handler(enabled(1 << 3)), raise, {jump(0)}}), {jump(0)});
    EXPECT_EQ(cpu().core().csr(MCAUSE), riscv_cause::INTERRUPT | 3);
    EXPECT_EQ(cpu().core().reg(3), 0u);
}

TEST_F(NiosV, CountsTimeFromPowerOn) {
    run(joined({li(1, TIMER), {lw(2, 1, 0), lw(3, 1, 4)}, li(4, PROBE), {sw(2, 4, 0), jump(0)}}));
    EXPECT_EQ(system->probe.values[0], 3u);  // two instructions, and the timer's 10 ns
}

TEST_F(NiosV, HasNoTimerInterruptBeforeOneIsAskedFor) {
    run(joined({with_handler(enabled(1 << 7)), {jump(0)}}), {jump(0)}, 50);
    EXPECT_EQ(cpu().counts().interrupts, 0u);
}

// ---- The addresses of pictures ------------------------------------------------------------------

TEST_F(NiosV, ReadsTheAddressOfAPictureWithoutTheArmsUpperBits) {
    system.reset();
    const Words code = joined({li(1, 0xFF203020),
                               li(2, 0xC8000000),
                               {sw(2, 1, 0), lw(3, 1, 0)},
                               {sw(2, 1, 8), lw(4, 1, 8), jump(0)}});
    run(code);
    EXPECT_EQ(cpu().core().reg(3), 0x08000000u);
    EXPECT_EQ(cpu().core().reg(4), 0xC8000000u);  // PIXEL_RESOLUTION is none
}

}  // namespace tb::riscv
