// run() counts and stops exactly: random programs do the same in pieces of any length as they do in
// single steps.
#include <gmock/gmock.h>

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "tb/sim/arm_core/bench.h"
#include "tb/sim/arm_core/program.h"

namespace counting {

using namespace tb::core;
using sim::ArmStop;

constexpr std::uint32_t AT = 0x8000;
constexpr unsigned PROGRAMS = 20, INSTRUCTIONS = 3000;

struct Moment {
    std::array<std::uint32_t, 16> r;
    std::uint32_t cpsr;
    ArmStop stop;  // what ended the instruction before

    bool operator==(const Moment& o) const { return r == o.r && cpsr == o.cpsr && stop == o.stop; }
};

Moment moment(const sim::ArmCore& core, ArmStop stop) {
    Moment now{{}, core.cpsr(), stop};
    for (unsigned i = 0; i < 16; ++i) now.r[i] = core.reg(i);
    return now;
}

class Counting : public ::testing::TestWithParam<bool> {
protected:
    Random random{1};
    Program program;
    std::vector<Moment> steps;  // after each instruction, by run(1)
    std::vector<Bench::Access> accesses;

    void make(unsigned number) {
        random.seed(number);
        program = make_program(random, {GetParam(), true, true, true}, AT);
        Bench bench;
        start(bench);
        steps = {moment(bench.core, ArmStop::LIMIT)};
        while (steps.size() <= INSTRUCTIONS) {
            const ArmStop stop = bench.core.run(1);
            ASSERT_EQ(bench.core.instructions(), steps.size())
                << "from " << std::hex << steps.back().r[15] << " to " << bench.core.pc();
            steps.push_back(moment(bench.core, stop));
        }
        accesses = bench.accesses;
    }
    void start(Bench& bench) {
        random.seed(~0ull);
        bench.put_halves(AT, program.code);
        bench.core.reset(AT | program.thumb, RAM / 2);
        for (unsigned i = 0; i < 15; ++i)
            bench.core.set_reg(i, static_cast<std::uint32_t>(random()));
        bench.core.set_reg(program.registers.low_any, BUS + 0x400);
        bench.core.set_reg(program.registers.high_any, RAM - 16);
        bench.core.set_reg(program.registers.low_index, 0x20);
        bench.core.set_reg(14, program.blocks.back() | program.thumb);
    }
    std::uint64_t any_limit() {
        const unsigned kind = static_cast<unsigned>(random() % 4);
        return 1 + random() % (kind == 0 ? 4 : kind == 1 ? 40 : kind == 2 ? 400 : 2000);
    }
    // Of the instruction at `pc`.
    std::uint32_t bytes(Bench& bench, std::uint32_t pc) const {
        return program.thumb && (bench.word(pc) & 0xFFFF) < 0xE800 ? 2 : 4;
    }
    std::string shown(const Moment& m) const {
        std::string text =
            fmt::format("pc {:x} cpsr {:x} stop {}:", m.r[15], m.cpsr, static_cast<int>(m.stop));
        for (unsigned i = 0; i < 15; ++i) text += fmt::format(" {:x}", m.r[i]);
        return text;
    }
    // The present state is that of the single steps after as many instructions.
    void compare_moment(Bench& bench, ArmStop stop, std::uint64_t before) {
        const std::uint64_t now = bench.core.instructions();
        const Moment actual = moment(bench.core, now == before ? steps[now].stop : stop);
        ASSERT_EQ(shown(actual), shown(steps[now])) << "after " << now << ", from " << before;
    }
    // All the way in pieces.
    void run(
        Bench& bench, const std::function<void()>& after = [] {}) {
        while (bench.core.instructions() < INSTRUCTIONS) {
            const std::uint64_t before = bench.core.instructions(),
                                limit = std::min(any_limit(), INSTRUCTIONS - before);
            const ArmStop stop = bench.core.run(limit);
            ASSERT_LE(bench.core.instructions(), before + limit);
            compare_moment(bench, stop, before);
            after();
            if (HasFatalFailure()) return;
        }
    }
    void each_program(const std::function<void(Bench&)>& test) {
        for (unsigned number = 0; number < PROGRAMS && !HasFailure(); ++number) {
            SCOPED_TRACE(number);
            make(number);
            Bench bench;
            start(bench);
            test(bench);
            if (!HasFatalFailure()) compare_accesses(bench);
        }
    }
    void compare_accesses(const Bench& bench) {
        ASSERT_EQ(bench.accesses.size(), accesses.size());
        for (std::size_t i = 0; i < accesses.size(); ++i)
            ASSERT_EQ(bench.accesses[i], accesses[i])
                << "access " << i << ": pc " << std::hex << accesses[i].pc << " at " << std::dec
                << accesses[i].count << ", is at " << bench.accesses[i].count;
    }
};

TEST_P(Counting, StopsAfterExactlyAsManyInstructionsAsWereAskedFor) {
    each_program([&](Bench& bench) { run(bench); });
}

TEST_P(Counting, StopsAfterTheInstructionWhoseAccessAsksForIt) {
    each_program([&](Bench& bench) {
        std::optional<std::uint64_t> asked;
        bench.on_access = [&] {
            if (random() % 4 != 0 || asked) return;
            bench.core.stop_soon();
            asked = bench.core.instructions();
        };
        run(bench, [&] {
            ASSERT_EQ(bench.core.instructions(), asked.value_or(bench.core.instructions()));
            asked.reset();
        });
    });
}

TEST_P(Counting, StopsTheRequestedNumberOfInstructionsAfterAnAccess) {
    each_program([&](Bench& bench) {
        std::uint64_t end = 0;
        bench.on_access = [&] {
            const std::uint64_t left = random() % 300;
            if (bench.core.instructions() + left > INSTRUCTIONS) return;
            bench.core.stop_after(left);
            end = bench.core.instructions() + left;
        };
        while (bench.core.instructions() < INSTRUCTIONS) {
            end = INSTRUCTIONS;
            const std::uint64_t before = bench.core.instructions();
            const ArmStop stop = bench.core.run(INSTRUCTIONS - before);
            ASSERT_TRUE(stop != ArmStop::LIMIT || bench.core.instructions() == end);
            compare_moment(bench, stop, before);
            if (HasFatalFailure()) return;
        }
    });
}

// Breakpoints at a few addresses, some of them never reached; each stops half of the times.
TEST_P(Counting, AsksTheProbeAtItsAddressesAlone) {
    struct Probe final : sim::ArmProbe {
        bool before(std::uint32_t pc) override {
            if (passed) {  // asked again where it has held
                passed = false;
                return false;
            }
            met.emplace_back(bench.core.instructions(), pc);
            return passed = random() % 2;
        }
        Bench& bench;
        Random random{7};
        bool passed = false;
        std::vector<std::pair<std::uint64_t, std::uint32_t>> met;
        explicit Probe(Bench& b) : bench{b} {}
    };
    each_program([&](Bench& bench) {
        Probe probe{bench};
        std::vector<std::uint32_t> at;
        for (unsigned i = 0; i < 6; ++i) at.push_back(steps[random() % INSTRUCTIONS].r[15]);
        at.push_back(AT + 2 * program.code.size());
        run(bench, [&] {
            if (bench.core.instructions() < 500 || !probe.met.empty()) return;
            bench.core.attach(&probe, at);  // when all has been translated
            probe.met.emplace_back(bench.core.instructions(), 0);
        });
        if (HasFatalFailure()) return;
        std::vector<std::pair<std::uint64_t, std::uint32_t>> expected{probe.met.front()};
        for (std::uint64_t i = probe.met.front().first; i < INSTRUCTIONS; ++i)
            if (std::find(at.begin(), at.end(), steps[i].r[15]) != at.end())
                expected.emplace_back(i, steps[i].r[15]);
        ASSERT_EQ(probe.met, expected);
    });
}

TEST_P(Counting, TalliesEachInstructionOnceWhereItWas) {
    struct Tally final : sim::ArmTally {
        explicit Tally(const std::vector<std::uint32_t>& begins_) : begins{begins_} {}
        const std::vector<std::uint32_t>& begins;  // of functions
        void ran(const Run& run) override { runs.push_back(run); }
        bool same_function(std::uint32_t pc, std::uint32_t other) const override {
            return std::upper_bound(begins.begin(), begins.end(), pc) ==
                   std::upper_bound(begins.begin(), begins.end(), other);
        }
        std::vector<Run> runs;
    };
    std::uint64_t calls = 0;
    each_program([&](Bench& bench) {
        Tally tally{program.blocks};
        bench.core.attach(&tally);
        run(bench);
        if (HasFatalFailure()) return;
        std::uint64_t done = 0;
        for (const auto& run : tally.runs) {
            ASSERT_EQ(run.begin, steps[done].r[15]) << "after " << done;
            ASSERT_EQ(run.link, steps[done].r[14]) << "after " << done;
            std::uint32_t after = 0;
            for (std::uint64_t left = run.instructions; left > 0; --left, ++done) {
                const std::uint32_t pc = steps[done].r[15];
                // Unless it has fallen in from the one above.
                ASSERT_TRUE(tally.same_function(run.begin, pc) || pc == after) << "at " << done;
                after = pc + bytes(bench, pc);
            }
            if (done == steps.size()) break;
            const std::uint32_t link = steps[done].r[14] & ~1u;
            const bool called = link == after && steps[done - 1].r[14] != steps[done].r[14];
            ASSERT_TRUE(run.end == link ? link == after : !called) << "at " << done;
            calls += called;
        }
        ASSERT_EQ(done, bench.core.instructions());
    });
    EXPECT_GT(calls, 0u);
}

TEST_P(Counting, ShowsTheWatchEachAccessOnce) {
    struct Watch final : sim::ArmWatch {
        bool touched(std::uint32_t address, unsigned, bool write) override {
            bus += address >= BUS;
            writes += write;
            return false;
        }
        unsigned bus = 0, writes = 0;
    };
    each_program([&](Bench& bench) {
        Watch watch;
        bench.core.watch(&watch);
        run(bench);
        ASSERT_EQ(watch.bus, accesses.size());
    });
}

INSTANTIATE_TEST_SUITE_P(Of, Counting, ::testing::Bool(),
                         [](const auto& given) { return given.param ? "Thumb" : "Arm"; });

// ---- Blocks that overlap ------------------------------------------------------------------------

// Code that is entered at three places, first with data in RAM and then on the bus.
class Overlapping : public ::testing::TestWithParam<bool> {
protected:
    static constexpr std::uint32_t NOPS = 6, BEHIND = 2;

    std::uint32_t bytes() const { return GetParam() ? 2 : 4; }
    void put(std::uint32_t at) {
        if (GetParam())  // NOP, LDR r6, [r7], WFI, B
            bench.put_halves(at, {0xBF00, 0xBF00, 0xBF00, 0xBF00, 0xBF00, 0xBF00, 0x683E, 0xBF00,
                                  0xBF00, 0xBF30, 0xE7FE});
        else
            bench.put(at, {0xE320F000, 0xE320F000, 0xE320F000, 0xE320F000, 0xE320F000, 0xE320F000,
                           0xE5976000, 0xE320F000, 0xE320F000, 0xE320F003, 0xEAFFFFFE});
    }
    // From the NOP `first` to WFI.
    void run(std::uint32_t at, unsigned first, std::uint32_t data) {
        const std::uint64_t before = bench.core.instructions();
        bench.core.set_cpsr(0x1D3 | (GetParam() ? 0x20 : 0));
        bench.core.set_reg(7, data);
        bench.core.set_reg(15, at + first * bytes());
        EXPECT_EQ(bench.core.run(1000), ArmStop::WFI);
        EXPECT_EQ(bench.core.instructions() - before, NOPS - first + 1 + BEHIND + 1);
        if (data != BUS) return;
        if (++at_bus > 1) {  // the first may be early
            EXPECT_EQ(bench.accesses.back().count - before, NOPS - first + 1);
        }
    }

    Bench bench;
    unsigned at_bus = 0;
};

TEST_P(Overlapping, CountsBeforeAnAccessFromAnyEntry) {
    std::uint32_t at = AT;
    for (const unsigned first : {0, 2, 4})
        for (const unsigned second : {0, 2, 4})
            for (const unsigned third : {0, 2, 4}) {
                SCOPED_TRACE(fmt::format("{}, {}, {}", first, second, third));
                put(at += 0x100);
                at_bus = 0;
                run(at, first, RAM / 2);
                run(at, second, RAM / 2);
                for (const unsigned again : {third, first, second, third}) run(at, again, BUS);
            }
}

INSTANTIATE_TEST_SUITE_P(Blocks, Overlapping, ::testing::Bool(),
                         [](const auto& given) { return given.param ? "Thumb" : "Arm"; });

// Branches to themselves: in ARM, in Thumb, in Thumb with 32 bits.
TEST(Spin, IsDoneExactlyAsOftenAsWasAskedFor) {
    const std::vector<std::uint16_t> spins[] = {{0xFFFE, 0xEAFF}, {0xE7FE}, {0xF7FF, 0xBFFE}};
    for (const auto& spin : spins) {
        Bench bench;
        bench.put_halves(AT, spin);
        bench.core.reset(AT | (spin[0] != 0xFFFE), RAM / 2);
        std::uint64_t done = 0;
        for (unsigned limit = 1; limit < 100; ++limit) {
            EXPECT_EQ(bench.core.run(limit), ArmStop::LIMIT);
            EXPECT_EQ(bench.core.instructions(), done += limit);
            EXPECT_EQ(bench.core.pc(), AT);
        }
    }
}

TEST(Spin, IsLeftWhereAnItBlockGivesItACondition) {
    for (const unsigned limit : {1, 2, 5, 20, 31, 40}) {
        std::vector<std::uint16_t> code{0x2001, 0x2800, 0xBF08, 0xE7FE};    // MOVS, CMP, IT EQ, B
        code.resize(200, 0x3101);                                           // ADDS r1, #1
        for (std::size_t i = 9; i < code.size(); i += 5) code[i] = 0xE7FF;  // B to the next
        Bench bench;
        bench.put_halves(AT, code);
        bench.core.reset(AT | 1, RAM / 2);
        bench.core.run(150);  // all is translated
        bench.core.reset(AT | 1, RAM / 2);
        const std::uint64_t before = bench.core.instructions();
        bench.core.run(3);
        EXPECT_EQ(bench.core.run(limit), ArmStop::LIMIT);
        EXPECT_EQ(bench.core.instructions(), before + 3 + limit);
    }
}

}  // namespace counting
