// steady_bus.h - what a processor asks of the rest of the chip to leave out accesses whose answers
// are known: ArmCpu::set_steady_bus().
#pragma once

#include <cstdint>
#include <optional>

#include "sim/hps/running_count.h"

namespace sim {

class SteadyBus {
public:
    // As long as this number stays, and no event of SystemC comes, nothing that can be read changes
    // but by what the processor writes.
    virtual std::uint64_t changes() const = 0;
    // Reading a register that gives `value` has no other effect, and gives it again as long as
    // nothing changes; writing `value` again has none.
    virtual bool is_plain(std::uint32_t address, bool write, std::uint32_t value) const = 0;
    // How the counter goes on that is read there, without another effect; nothing if there is none.
    virtual std::optional<RunningCount> running(std::uint32_t /*address*/,
                                                std::uint64_t /*time_ps*/) const {
        return {};
    }
    // How long such an access takes, in ps; 0 if that depends on when it is made.
    virtual std::uint64_t fixed_ps(std::uint32_t address) const = 0;
    // ... and then the time at which one ends that begins at `begin_ps`, both of SystemC's time.
    // Nothing if something may change meanwhile.
    virtual std::optional<std::uint64_t> again(bool write, std::uint64_t begin_ps) = 0;
    // So many were left out.
    virtual void left_out(bool write, std::uint64_t accesses) = 0;

protected:
    ~SteadyBus() = default;
};

}  // namespace sim
