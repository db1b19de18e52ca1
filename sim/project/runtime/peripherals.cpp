#include "sim/project/runtime/peripherals.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sim/project/runtime/endings.h"

#include "svdpi.h"

namespace sim::project {

namespace {

struct PeripheralSignals {
    Peripheral which;
    std::uint64_t from_design, to_design;
};
// In the order of the design's instances; a handle is the index, from 1 on.
std::vector<PeripheralSignals> peripheral_signals;
const PlacedUart* placed_uarts = nullptr;
std::vector<int> moved_peripherals;  // handles, since somebody has looked

PeripheralSignals& signals_by(int handle) {
    return peripheral_signals[static_cast<std::size_t>(handle) - 1];
}

PeripheralSignals* signals_of(Peripheral which) {
    for (PeripheralSignals& signals : peripheral_signals)
        if (signals.which.kind == which.kind && signals.which.number == which.number)
            return &signals;
    return nullptr;
}

// "fpga_interfaces.peripheral_uart1": the primitive, around de1sim_hps_wires.
std::string primitive_of_scope() {
    std::string name = svGetNameFromScope(svGetScope());
    const std::string design = "de1sim_design.";
    if (const auto begin = name.find(design); begin != std::string::npos)
        name.erase(0, begin + design.size());
    return name.substr(0, name.rfind('.'));
}

// By HPS_LOCATION, else by the last character of the instance's name, else 0.
unsigned number_of(Peripheral::Kind kind, unsigned count) {
    const std::string name = primitive_of_scope(), own = name.substr(name.rfind('.') + 1);
    if (kind == Peripheral::UART)
        for (const PlacedUart* uart = placed_uarts; *uart->instance; ++uart)
            if (own == uart->instance) return uart->number;
    const char last = own.empty() ? 'x' : own.back();
    return last >= '0' && last < static_cast<char>('0' + count) ? static_cast<unsigned>(last - '0')
                                                                : 0;
}

}  // namespace

DesignPeripherals::DesignPeripherals(const PlacedUart* placed) {
    placed_uarts = placed;
    peripheral_signals.clear();
    moved_peripherals.clear();
    have_moved = false;
}

bool DesignPeripherals::have_moved = false;

bool DesignPeripherals::has(Peripheral which) const { return signals_of(which) != nullptr; }

void DesignPeripherals::connect(ProcessorWires& wires, std::uint64_t now_ps) {
    wires_ = &wires;
    moved_peripherals.clear();
    for (std::size_t n = 0; n < peripheral_signals.size(); ++n)
        moved_peripherals.push_back(static_cast<int>(n) + 1);
    tell_moved(now_ps);
}

bool DesignPeripherals::drive(Peripheral which, std::uint64_t levels) {
    PeripheralSignals* const signals = signals_of(which);
    return signals && std::exchange(signals->to_design, levels) != levels;
}

void DesignPeripherals::tell_moved(std::uint64_t now_ps) {
    if (!wires_) return;
    have_moved = false;
    for (const int handle : std::exchange(moved_peripherals, {})) {
        const PeripheralSignals& signals = signals_by(handle);
        wires_->moved(signals.which, signals.from_design, now_ps);
    }
}

}  // namespace sim::project

using namespace sim::project;

extern "C" int de1sim_hps_peripheral(int kind, int number, long long idle) {
    static constexpr unsigned COUNTS[] = {2, 4, 2, 2, 3, 1};  // by Peripheral::Kind
    const unsigned count = COUNTS[kind];
    sim::Peripheral which{static_cast<sim::Peripheral::Kind>(kind), static_cast<unsigned>(number)};
    if (number < 0) which.number = number_of(which.kind, count);
    if (signals_of(which))
        end_run(Ending::Kind::STOPPED,
                primitive_of_scope() + ": number " + std::to_string(which.number) +
                    " of its kind is in the design already: expected instances whose names end "
                    "with different numbers, from 0 to " +
                    std::to_string(count - 1));
    const auto levels = static_cast<std::uint64_t>(idle);
    peripheral_signals.push_back({which, 0, levels});
    return static_cast<int>(peripheral_signals.size());
}

extern "C" void de1sim_hps_signals(int handle, long long levels) {
    if (handle == 0) return;
    PeripheralSignals& signals = signals_by(handle);
    if (std::exchange(signals.from_design, levels) == static_cast<std::uint64_t>(levels)) return;
    moved_peripherals.push_back(handle);
    DesignPeripherals::have_moved = true;
}

extern "C" long long de1sim_hps_levels(int handle) {
    return static_cast<long long>(signals_by(handle).to_design);
}
