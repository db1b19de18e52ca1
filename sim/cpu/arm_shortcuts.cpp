#include "sim/cpu/arm_shortcuts.h"

#include <algorithm>

#include "sim/hps/bridge_windows.h"

namespace sim {

using sc_core::sc_time;

namespace {

constexpr unsigned WORTH = 64;                 // instructions: of fewer it is not
constexpr unsigned LONG = 2000;                // instructions, of a loop that ends
constexpr unsigned FEW = 16;                   // instructions until one is known
constexpr std::uint64_t ELSEWHERE = 400;       // until the program may be in another loop
constexpr unsigned LOOKS = 4;                  // in vain, one after another
constexpr unsigned PATIENCE = 8, RARELY = 32;  // looks where no loop is; then one of these
constexpr unsigned LONGEST_PAUSE = 8;          // quanta

}  // namespace

class ArmShortcuts::World final : public SteadyLoop::World {
public:
    World(ArmShortcuts& owner, std::uint64_t epoch)
        : owner_{owner}, core_{owner.core_}, answers_{owner.answers_}, epoch_{epoch} {}

    std::optional<std::uint32_t> code(std::uint32_t pc, bool thumb) override {
        return core_.code_at(pc, thumb);
    }
    Place place(std::uint32_t address, bool write) override {
        const ArmCore::Place place = core_.place(address, write);
        fpga_memory |= place.ram && address >= H2F_BASE;  // the FPGA may write it, too
        return {place.ram, place.bus.has_value(), place.bus.value_or(0)};
    }
    std::optional<std::uint32_t> answer(const SteadyLoop::Use& use) override {
        const auto known = answers_.last(use.address, use.bytes, use.write, epoch_);
        unknown |= !known;
        if (!known || (use.write && known->value != use.value)) return std::nullopt;
        sure &= known->sure;
        return known->value;
    }

    // Of one whose register has answered before, so none that is in reset.
    std::optional<RunningCount> counter(const SteadyLoop::Use* uses, unsigned count) override {
        const SteadyLoop::Use& use = uses[count - 1];
        if (!owner_.bus_ || use.bytes != 4 ||
            !answers_.last(use.address, use.bytes, use.write, epoch_))
            return std::nullopt;
        const std::uint64_t ps = round_ps(uses, count, use.at);
        if (ps == 0) return std::nullopt;
        return owner_.bus_->running(use.address, owner_.time_.now().value() + ps);
    }
    std::uint64_t round_ps(const SteadyLoop::Use* uses, unsigned count,
                           unsigned instructions) override {
        std::uint64_t ps = instructions * owner_.time_.instruction_ps();
        for (unsigned i = 0; i < count; ++i) {
            const std::uint64_t fixed = owner_.bus_->fixed_ps(uses[i].address);
            if (fixed == 0) return 0;
            ps += fixed;
        }
        return ps;
    }
    std::optional<Cycles> cycles(unsigned at) override {
        const std::optional<ArmCore::Cycles> cycles = core_.cycles();
        if (!cycles) return std::nullopt;
        return Cycles{cycles->now + (cycles->counts ? at - 1 : 0), cycles->counts};
    }

    bool sure = true, unknown = false, fpga_memory = false;

private:
    ArmShortcuts& owner_;
    ArmCore& core_;
    Answers& answers_;
    const std::uint64_t epoch_;
};

std::uint64_t ArmShortcuts::pass(std::uint64_t most, bool stores_wait) {
    if (!enabled_ || !replays_.empty()) return most;
    if (pause_ > 0) {
        --pause_;
        return most;
    }
    NoLoop& here = no_loop_[core_.pc() / 2 % no_loop_.size()];
    if (here.pc != core_.pc()) here = {core_.pc(), 0};
    if (here.times > PATIENCE && ++here.times % RARELY != 0) return std::min(most, ELSEWHERE);
    World world{*this, epoch()};
    std::uint64_t next = 0;  // instructions to the next look, if this has been in vain
    if (loop_.follow(registers(core_.pc()), world)) {
        here.times = 0;
        const bool on_bus = loop_.use_count() > 0;
        if (!on_bus) {
            const unsigned size = loop_.instructions();
            const bool ends_late = loop_.rounds() <= most / size && loop_.rounds() * size >= LONG;
            if (pass_memory(most))  // the next loop may begin soon
                return std::max<std::uint64_t>(
                    ends_late ? std::min<std::uint64_t>(time_.budget(), 2 * size + FEW)
                              : time_.budget(),
                    1);
        } else if (world.sure && bus_ && !world.fpga_memory && !stores_wait) {
            if (pass_bus())
                return std::min(2 * std::uint64_t{loop_.instructions()}, time_.budget());
        } else if (!world.sure) {
            next = loop_.instructions();
        }
    } else if (world.unknown) {
        next = loop_.instructions() + FEW;
    } else if (loop_.ahead()) {
        next = *loop_.ahead();
    } else {
        ++here.times;
    }
    if (next == 0) next = ELSEWHERE;
    if (++looks_ >= LOOKS) {
        looks_ = 0;
        pause_ = longest_pause_;
        longest_pause_ = std::min(2 * longest_pause_ + 1, LONGEST_PAUSE);
        return most;
    }
    return std::min(most, next);
}

void ArmShortcuts::passed(std::uint64_t rounds) {
    const SteadyLoop::Registers after = loop_.after(rounds);
    for (unsigned i = 0; i < 15; ++i)
        if (after.r[i] != core_.reg(i)) core_.set_reg(i, after.r[i]);
    for (unsigned i = 0; i < loop_.word_count(); ++i) {
        const SteadyLoop::Word& word = loop_.words()[i];
        const std::uint32_t value = loop_.word_after(i, rounds);
        if (value != word.value.base) core_.store_word(word.address, value);
    }
    core_.pass(rounds * loop_.instructions());
    looks_ = longest_pause_ = 0;
}

// Of a loop that stays in memory.  False: it has not been worth it.
bool ArmShortcuts::pass_memory(std::uint64_t most) {
    const std::uint64_t rounds = std::min(loop_.rounds(), most / loop_.instructions());
    if (rounds < 2 || (rounds - 1) * loop_.instructions() < WORTH) return false;
    passed(rounds - 1);
    time_.account();
    return true;
}

// Of one that uses the bus.  False likewise.
bool ArmShortcuts::pass_bus() {
    const std::uint64_t now = sc_core::sc_time_stamp().value(), end = now + time_.horizon().value();
    std::uint64_t round_ps = loop_.instructions() * time_.instruction_ps(), waits_ps = 0;
    bool all_fixed = true;
    for (unsigned i = 0; i < loop_.use_count(); ++i) {
        const std::uint64_t fixed = bus_->fixed_ps(loop_.uses()[i].address);
        all_fixed &= fixed > 0;
        waits_ps += fixed;
    }
    round_ps += waits_ps;
    const std::uint64_t begin = now + time_.ahead().value();
    std::uint64_t time = begin, rounds = 0;
    if (all_fixed) {
        if (end <= time) return false;
        rounds = std::min(loop_.rounds(), (end - time) / round_ps);
        if (rounds < 2) return false;
        time += --rounds * round_ps;
    } else {
        while (rounds + 1 < loop_.rounds() && go_round(time, end)) ++rounds;
        if (rounds == 0) return !replays_.empty();
    }
    for (unsigned i = 0; i < loop_.use_count(); ++i) bus_->left_out(loop_.uses()[i].write, rounds);
    passed(rounds);
    time_.skip(rounds * loop_.instructions());
    time_.ahead() = sc_time::from_value(time - now);
    on_bus_ +=
        sc_time::from_value(time - begin - rounds * loop_.instructions() * time_.instruction_ps());
    return true;
}

// The accesses of a round from `time` on.  False: they cannot all be left out before `end`; those
// that can are kept in `replays_`, and the round is executed.
bool ArmShortcuts::go_round(std::uint64_t& time, std::uint64_t end) {
    std::uint64_t at = time;
    unsigned done = 0;
    replays_.clear();
    for (unsigned i = 0; i < loop_.use_count(); ++i) {
        const SteadyLoop::Use& use = loop_.uses()[i];
        at += (use.at - done) * time_.instruction_ps();
        done = use.at;
        if (at >= end) break;
        const std::uint64_t fixed = bus_->fixed_ps(use.address);
        if (fixed && at + fixed >= end) break;
        const auto answered = fixed ? at + fixed : bus_->again(use.write, at);
        if (!answered) break;
        replays_.push_back(*answered);
        at = *answered;
    }
    at += (loop_.instructions() - done) * time_.instruction_ps();
    if (replays_.size() == loop_.use_count() && at < end) {
        replays_.clear();
        time = at;
        return true;
    }
    for (std::size_t i = 0; i < replays_.size(); ++i) bus_->left_out(loop_.uses()[i].write, 1);
    std::reverse(replays_.begin(), replays_.end());
    return false;
}

std::optional<std::uint32_t> ArmShortcuts::polled(std::uint32_t pc) {
    World world{*this, 0};
    SteadyLoop loop;
    if (!loop.follow_with_flags(registers(pc), world)) return std::nullopt;
    for (unsigned i = 0; i < loop.use_count(); ++i)
        if (!loop.uses()[i].write) return loop.uses()[i].address;
    return std::nullopt;
}

SteadyLoop::Registers ArmShortcuts::registers(std::uint32_t pc) const {
    SteadyLoop::Registers registers{{}, core_.cpsr()};
    for (unsigned i = 0; i < 15; ++i) registers.r[i] = core_.reg(i);
    registers.r[15] = pc;
    return registers;
}

void ArmShortcuts::answered(std::uint32_t address, unsigned bytes, bool write, std::uint32_t value,
                            bool waited) {
    // Whatever has come while it waited may not be in its answer.
    const bool plain = !waited && bus_ && bus_->is_plain(address, write, value);
    answers_.made(address, bytes, write, value, plain, epoch_before_);
}

bool ArmShortcuts::replay() {
    if (replays_.empty()) return false;
    time_.account();
    const sc_time end = sc_time::from_value(replays_.back()) - sc_core::sc_time_stamp();
    replays_.pop_back();
    on_bus_ += end - time_.ahead();
    time_.ahead() = end;
    return true;
}

}  // namespace sim
