#include "sim/chip/fpga_chip.h"

#include <algorithm>
#include <utility>

namespace sim {

namespace {

const sc_core::sc_time batch{32, sc_core::SC_US};
// 128 clocks of 25 MHz, as the reset manager's register counts has them (Cyclone V HPS TRM).
constexpr std::uint64_t RESET_PS = 5'120'000;

}  // namespace

// By Vigna's splitmix64.
std::uint64_t ClockPhases::seen(std::uint64_t time_ps, std::uint64_t earliest_ps) {
    if (!clock_ps_) return std::max(time_ps, earliest_ps);
    const std::uint64_t half_ps = clock_ps_ / 2;
    std::uint64_t z = seed_ + ++meetings_ * 0x9E3779B97F4A7C15;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return std::max(time_ps, earliest_ps + half_ps) - half_ps + (z ^ (z >> 31)) % clock_ps_;
}

FpgaChip::FpgaChip(const sc_core::sc_module_name& name, PinListener& pins, FpgaModel& model,
                   ClockPhases phases)
    : sc_module{name}, pins_{pins}, model_{model}, phases_{phases} {
    SC_HAS_PROCESS(FpgaChip);
    SC_METHOD(look);
    sensitive << look_;
    SC_METHOD(board_moves);
    sensitive << board_moves_;
    dont_initialize();
    SC_METHOD(end_reset);
    sensitive << reset_ends_;
    dont_initialize();
}

FpgaChip::~FpgaChip() {
    pins_.agenda.on_next([](std::uint64_t) {});
}

void FpgaChip::run_to(std::uint64_t time_ps) {
    if (time_ps >= model_.time_ps()) time_ps_ = time_ps;  // not ahead of that, by an access
    ++batches_;
    is_running_ = true;
    model_.run(time_ps);
    is_running_ = false;
    notify_processor();
}

bool FpgaChip::run_to_answer(std::uint64_t until_ps) {
    is_running_ = true;
    const bool is_answered = model_.run_to_answer(until_ps);
    is_running_ = false;
    return is_answered;
}

bool FpgaChip::run_to_posted(std::uint64_t until_ps, unsigned most) {
    is_running_ = true;
    const bool is_answered = model_.run_to_posted(until_ps, most);
    is_running_ = false;
    return is_answered;
}

void FpgaChip::catch_up() {
    run_to(sc_core::sc_time_stamp().value());
    model_.flush();
}

void FpgaChip::on_processor_wires(Wires wires) {
    wires_ = std::move(wires);
    pins_.agenda.on_next([this](std::uint64_t next_ps) { wait_for_board(next_ps); });
}

void FpgaChip::notify_processor() {
    if (wires_.interrupts && model_.interrupts() != interrupts_)
        wires_.interrupts(interrupts_ = model_.interrupts());
    if (wires_.reset_requests && model_.reset_requests() != reset_requests_)
        wires_.reset_requests(reset_requests_ = model_.reset_requests());
}

void FpgaChip::reset(bool cold) {
    const std::uint64_t now_ps = sc_core::sc_time_stamp().value();
    run_to(now_ps);
    model_.reset(true, cold);
    const std::uint64_t begin_ps = std::max(model_.time_ps(), now_ps);
    reset_ends_.notify(picoseconds(begin_ps + RESET_PS - now_ps));
}

void FpgaChip::end_reset() {
    run_to(sc_core::sc_time_stamp().value());
    model_.reset(false, false);
}

void FpgaChip::wait_for_board(std::uint64_t next_ps) {
    board_moves_.cancel();
    if (next_ps == Agenda::NEVER) return;
    const std::uint64_t now_ps = sc_core::sc_time_stamp().value();
    board_moves_.notify(picoseconds(std::max(next_ps, now_ps) - now_ps));
}

void FpgaChip::board_moves() { run_to(sc_core::sc_time_stamp().value()); }

void FpgaChip::look() {
    catch_up();
    look_.notify(picoseconds(phases_.seen(batch.value(), 0)));
}

}  // namespace sim
