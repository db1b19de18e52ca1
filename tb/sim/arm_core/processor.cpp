// The processor under test as a Machine.
#include <fmt/format.h>

#include "sim/cpu/arm_core.h"
#include "tb/sim/arm_core/machine.h"

namespace tb::core {

namespace {

class NoBus final : public sim::ArmBus {
    bool read(std::uint32_t, unsigned, std::uint32_t&) override { return false; }
    bool write(std::uint32_t, unsigned, std::uint32_t) override { return false; }
};

class Processor final : public Machine {
public:
    explicit Processor(bool stepping) : stepping_{stepping} {
        reset();
        core_.map_ram(CODE, PART, memory->code.data(),
                      sim::arm_access::ALL | sim::arm_access::NORMAL);
        for (std::uint32_t i = 0; i < PARTS; ++i)
            for (const std::uint32_t base : {DATA, FAR_DATA})
                core_.map_ram(base + i * PART, PART, memory->data.data(),
                              sim::arm_access::ALL | sim::arm_access::NORMAL);
    }

    void set(const State& state) override {
        core_.set_cpsr(state.cpsr);
        for (unsigned i = 0; i < 15; ++i) core_.set_reg(i, state.r[i]);
        for (unsigned i = 0; i < 32; ++i) core_.set_vfp(i, state.d[i]);
        core_.set_fpscr(state.fpscr);
    }
    State state() const override {
        State state;
        for (unsigned i = 0; i < 15; ++i) state.r[i] = core_.reg(i);
        for (unsigned i = 0; i < 32; ++i) state.d[i] = core_.vfp(i);
        state.cpsr = core_.cpsr();
        state.fpscr = core_.fpscr();
        return state;
    }

    // The branch after the stream, to itself, belongs to its block.
    std::uint32_t run(std::uint32_t begin, std::uint32_t, unsigned instructions) override {
        core_.set_reg(15, begin);
        auto stop = sim::ArmStop::LIMIT;
        if (!stepping_) stop = core_.run(instructions + 1);
        if (stepping_)
            for (unsigned i = 0; i < instructions && stop == sim::ArmStop::LIMIT; ++i)
                stop = core_.run(1);
        if (stop == sim::ArmStop::UNDEFINED) return core_.pc() + UNDEFINED;
        if (stop == sim::ArmStop::DATA_ABORT && core_.fault().multiple_of > 1)
            return core_.pc() + UNALIGNED;
        return stop == sim::ArmStop::LIMIT ? core_.pc() : OTHER;
    }

    std::uint32_t run_on(std::uint32_t begin, unsigned instructions) override {
        core_.set_reg(15, begin);
        return core_.run(instructions) == sim::ArmStop::LIMIT ? core_.pc() : OTHER;
    }

    void code_changed(std::uint32_t begin, std::uint32_t bytes) override {
        core_.forget_translations(begin, bytes);
        // Dynarmic keeps a place for each address and rounding mode; these are all of them.
        if (++changes_ % 512 == 0) reset();
    }

private:
    void reset() {
        core_.reset(CODE, 0);
        core_.set_floating_point(true);
    }

    NoBus bus_;
    sim::ArmCore core_{bus_};
    bool stepping_;
    unsigned changes_ = 0;
};

}  // namespace

std::unique_ptr<Machine> processor(bool stepping) { return std::make_unique<Processor>(stepping); }

std::string difference(const State& expected, const State& actual, std::uint32_t fpscr_mask) {
    std::string text;
    const auto compare = [&](const std::string& name, std::uint64_t e, std::uint64_t a) {
        if (e != a) text += fmt::format("  {:6} expected {:016x}, is {:016x}\n", name, e, a);
    };
    for (unsigned i = 0; i < 15; ++i) compare(fmt::format("r{}", i), expected.r[i], actual.r[i]);
    for (unsigned i = 0; i < 32; ++i) compare(fmt::format("d{}", i), expected.d[i], actual.d[i]);
    compare("cpsr", expected.cpsr, actual.cpsr);
    compare("fpscr", expected.fpscr & fpscr_mask, actual.fpscr & fpscr_mask);
    return text;
}

}  // namespace tb::core
