#include "sim/chip/project_chip.h"

#include <dlfcn.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sim/project/runtime/analog.h"
#include "sim/text/messages.h"

namespace sim {

namespace {

const sc_core::sc_time batch{32, sc_core::SC_US};
// 128 clocks of 25 MHz, as the reset manager's register counts has them (Cyclone V HPS TRM).
constexpr std::uint64_t RESET_PS = 5'120'000;

}  // namespace

void ProjectChip::Unload::operator()(void* library) const { dlclose(library); }

ProjectChip::ProjectChip(const sc_core::sc_module_name& name, PinListener& pins,
                         const std::filesystem::path& library, const std::string& folder,
                         const Trace& trace, project::JtagTerminals* terminals,
                         project::ProcessorMemory* memory)
    : sc_module{name}, library_{dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL)}, pins_{pins} {
    if (!library_) throw std::runtime_error{std::string{"cannot load the design: "} + dlerror()};
    const auto open =
        reinterpret_cast<project::OpenModel*>(dlsym(library_.get(), "de1sim_open_model"));
    if (!open) throw std::runtime_error{library.string() + ": is not a design that was built here"};
    if (const auto set_analog = reinterpret_cast<decltype(&de1sim_set_analog)>(
            dlsym(library_.get(), "de1sim_set_analog")))
        set_analog(&pins);
    model_.reset(open(pins, {folder.c_str(), trace, [](const char* line) { complain(line); },
                             terminals, memory}));
    SC_HAS_PROCESS(ProjectChip);
    SC_METHOD(look);
    sensitive << look_ << board_moves_;
    SC_METHOD(end_reset);
    sensitive << reset_ends_;
    dont_initialize();
}

ProjectChip::~ProjectChip() {
    pins_.agenda.on_next([](std::uint64_t) {});
}

void ProjectChip::run_to(std::uint64_t time_ps) {
    // Ahead of that already, by an access.
    if (time_ps >= model_->time_ps()) {
        is_running_ = true;
        model_->run(time_ps_ = time_ps);
        is_running_ = false;
    }
    notify_processor();
}

bool ProjectChip::run_to_answer(std::uint64_t until_ps) {
    is_running_ = true;
    const bool is_answered = model_->run_to_answer(until_ps);
    is_running_ = false;
    return is_answered;
}

void ProjectChip::catch_up() {
    run_to(sc_core::sc_time_stamp().value());
    model_->flush();
}

void ProjectChip::on_processor_wires(Wires wires) {
    wires_ = std::move(wires);
    pins_.agenda.on_next([this](std::uint64_t next_ps) { wait_for_board(next_ps); });
}

void ProjectChip::notify_processor() {
    if (wires_.interrupts && model_->interrupts() != interrupts_)
        wires_.interrupts(interrupts_ = model_->interrupts());
    if (wires_.reset_requests && model_->reset_requests() != reset_requests_)
        wires_.reset_requests(reset_requests_ = model_->reset_requests());
}

void ProjectChip::reset(bool cold) {
    const std::uint64_t now_ps = sc_core::sc_time_stamp().value();
    run_to(now_ps);
    model_->reset(true, cold);
    const std::uint64_t begin_ps = std::max(model_->time_ps(), now_ps);
    reset_ends_.notify(sc_core::sc_time::from_value(begin_ps + RESET_PS - now_ps));
}

void ProjectChip::end_reset() {
    run_to(sc_core::sc_time_stamp().value());
    model_->reset(false, false);
}

void ProjectChip::wait_for_board(std::uint64_t next_ps) {
    board_moves_.cancel();
    if (next_ps == Agenda::NEVER) return;
    const std::uint64_t now_ps = sc_core::sc_time_stamp().value();
    board_moves_.notify(sc_core::sc_time::from_value(std::max(next_ps, now_ps) - now_ps));
}

std::optional<Chip::End> ProjectChip::end() const {
    using project::Ending;
    const Ending& ending = model_->ending();
    switch (ending.kind) {
        case Ending::Kind::NONE: return {};
        case Ending::Kind::FINISHED: return End{End::Kind::FINISHED, ending.message};
        case Ending::Kind::STOPPED: return End{End::Kind::FAILED, ending.message};
        case Ending::Kind::DIVERGED: break;
    }
    return End{End::Kind::BROKEN, ending.message};
}

void ProjectChip::look() {
    catch_up();
    look_.notify(batch);
}

}  // namespace sim
