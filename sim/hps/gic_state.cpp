// gic_state.cpp - which interrupt is to be taken
#include <algorithm>

#include "sim/hps/gic.h"

namespace sim {

namespace {

constexpr std::uint32_t ENABLE_SECURE = 1, ENABLE_NON_SECURE = 2, ACK_CTL = 4, FIQ_EN = 8;
constexpr std::uint8_t THIS_CPU = 1;
constexpr unsigned PRIVATE_IDS = 32, SOFTWARE_IDS = 16;

}  // namespace

GicState::GicState() {
    for (unsigned id = 0; id < SOFTWARE_IDS; ++id) enabled[id] = edge[id] = true;
    for (const unsigned id : {27u, 29u, 30u}) edge[id] = true;
    std::fill_n(targets.begin(), PRIVATE_IDS, THIS_CPU);
}

void GicState::set_level(unsigned id, bool up) {
    if (edge[id] && up && !level[id]) latched[id] = true;
    if (up && !level[id]) taken_[id] = 0;
    level[id] = up;
}

// The bits of a priority that decide about preemption.
unsigned GicState::group(unsigned priority_value) const {
    return priority_value & 0xFFu << (binary_point + 1);
}

bool GicState::is_fiq(unsigned id) const { return !non_secure[id] && (control & FIQ_EN); }

unsigned GicState::highest_pending() const {
    unsigned best = SPURIOUS, best_priority = mask;
    const Bits candidates = enabled & ~active & (latched | (level & ~edge));
    for (std::size_t next = candidates._Find_first(); next < IDS;
         next = candidates._Find_next(next)) {
        const auto id = static_cast<unsigned>(next);
        if (!(targets[id] & THIS_CPU)) continue;
        const bool on = non_secure[id] ? distribute_non_secure && (control & ENABLE_NON_SECURE)
                                       : distribute_secure && (control & ENABLE_SECURE);
        if (on && priority[id] < best_priority) best = id, best_priority = priority[id];
    }
    return best;
}

unsigned GicState::running_priority() const {
    unsigned lowest = IDLE_PRIORITY;
    for (const unsigned id : running_) lowest = std::min<unsigned>(lowest, priority[id]);
    return lowest;
}

void GicState::signals(bool& irq, bool& fiq) const {
    const unsigned id = highest_pending(), running = running_priority();
    const bool takes =
        id != SPURIOUS && (running == IDLE_PRIORITY || group(priority[id]) < group(running));
    irq = takes && !is_fiq(id);
    fiq = takes && is_fiq(id);
}

unsigned GicState::acknowledge() {
    bool irq, fiq;
    signals(irq, fiq);
    if (!irq && !fiq) return SPURIOUS;
    const unsigned id = highest_pending();
    if (non_secure[id] && !(control & ACK_CTL)) return SPURIOUS_NON_SECURE;
    latched[id] = false;
    active[id] = true;
    ++taken_[id];
    running_.push_back(id);
    return id;
}

// Ends may come out of order; one of an inactive interrupt is ignored.
void GicState::end(unsigned id) {
    const auto last = std::find(running_.rbegin(), running_.rend(), id);
    if (last == running_.rend()) return;
    running_.erase(std::next(last).base());
    active[id] = false;
}

}  // namespace sim
