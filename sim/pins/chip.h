// chip.h - what is in the Cyclone V, as the board and its user meet it: pins and time.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "sim/pins/pins.h"
#include "sim/pins/serial_line.h"

namespace sim {

// Where what a chip has to say beyond its pins goes.
class ChipObserver {
public:
    // A character that its program prints.
    virtual void console(char character, SerialLine line) = 0;
    // What a person should know of the program: aborts, resets.
    virtual void log(const std::string& /*line*/) {}

protected:
    ~ChipObserver() = default;
};

class Chip {
public:
    virtual ~Chip() = default;

    // The input pins, for the board's entries in its agenda (pins.h).
    virtual ChipInputs& inputs() = 0;
    // Everything up to now has been run, with the board's entries, and handed to the listener.
    virtual void catch_up() = 0;
    // How far the chip has come: behind the present, or ahead of it with a processor that is so.
    virtual std::uint64_t time_ps() const = 0;

    // HPS_KEY, and what a person types at a terminal.
    virtual void hps_key(bool /*pressed*/) {}
    // GPIO61 of the HPS, the accelerometer's INT1.
    virtual void hps_accelerometer_interrupt(bool /*up*/) {}
    virtual void type(const std::string& /*text*/, SerialLine /*to*/) {}

    // How what is in the chip has ended the run, as a line of text; nothing as long as it runs.
    struct End {
        enum class Kind { FINISHED, FAILED, BROKEN } kind;
        std::string message;
    };
    virtual std::optional<End> end() const { return {}; }

    // Writes out the rest of the waveforms; what follows is not in them.
    virtual void end_trace() {}
};

// Puts a chip on the board: onto these pins, with this observer for what it prints.  `sdram` points
// to the 64 MB of the memory chip beside it.
using ChipMaker = std::function<std::unique_ptr<Chip>(PinListener& pins, ChipObserver& observer,
                                                      std::uint8_t* sdram)>;

}  // namespace sim
