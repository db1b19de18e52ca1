#include "sim/project/quartus/pins.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>

#include <fmt/format.h>

#include "sim/text/lower.h"

namespace sim::project {

namespace {

struct Assigned {
    std::string pin;
    Place place;
};

class Pins {
public:
    Pins(const Project& project, const std::vector<Port>& ports)
        : board_{project.board}, board_pins_{board_.signals_by_pin()} {
        file_ = project.settings.filename().string();
        for (const Port& port : ports)
            for (int n = std::min(port.left, port.right); n <= std::max(port.left, port.right); ++n)
                bits_[lower(port.vector ? fmt::format("{}[{}]", port.name, n) : port.name)] = {};
        for (const auto& [name, pin] : project.pins) {
            const auto bit = bits_.find(lower(name));
            if (bit == bits_.end()) {
                ++others_;
                continue;
            }
            const std::string& place = project.places_of_pins.at(name);
            const std::size_t colon = place.rfind(':');
            bit->second = {pin,
                           {place.substr(0, colon), static_cast<unsigned>(std::strtoul(
                                                        place.c_str() + colon + 1, nullptr, 10))}};
        }
    }

    Messages errors() {
        std::map<std::string, std::string> taken;
        for (const auto& [name, assigned] : bits_) {
            if (assigned.pin.empty() || is_of_processor(name)) continue;
            if (!is_for_signals(assigned.pin)) {
                add(171016, assigned.place,
                    fmt::format("{} is assigned to {}, which is no pin for the FPGA's signals",
                                name, assigned.pin));
                continue;
            }
            const auto [first, is_new] = taken.emplace(assigned.pin, name);
            if (!is_new)
                add(176310, assigned.place,
                    fmt::format("{} and {} are both on {}; a pin is one port's", first->second,
                                name, assigned.pin));
        }
        return std::move(messages_);
    }

    Messages warnings() {
        std::string open;
        std::size_t count = 0;
        for (const auto& [name, assigned] : bits_) {
            if (assigned.pin.empty()) {
                if (is_of_processor(name)) continue;
                if (++count <= 3) open += (open.empty() ? "" : ", ") + name;
            } else if (board_pins_.count(assigned.pin) == 0 && !is_of_processor(name)) {
                add(171016, assigned.place,
                    fmt::format("{} is assigned to {}, where the board has nothing", name,
                                assigned.pin));
            }
        }
        if (others_)
            add(15706, {file_, 1},
                fmt::format("{} pins are assigned to what the top has not", others_));
        if (count)
            add(169085, {file_, 1},
                fmt::format("{} of the top's ports have no pin: Quartus chooses one, here they go "
                            "by their names: {}{}",
                            count == bits_.size() ? "all" : std::to_string(count), open,
                            count > 3 ? " ..." : ""));
        return std::move(messages_);
    }

private:
    // Its pins are those of the processor, whatever is assigned.
    static bool is_of_processor(const std::string& name) { return name.compare(0, 4, "hps_") == 0; }

    // All others are the processor's, for configuration, power and ground, or are not there.
    bool is_for_signals(const std::string& pin) const {
        if (board_.other_pins.empty() || pin.compare(0, 4, "PIN_") != 0)
            return true;  // not known; or a bank or an edge
        return board_pins_.count(pin) || board_.other_pins.count(pin);
    }

    void add(unsigned number, const Place& place, std::string text) {
        messages_.push_back({number, place.file, place.line, std::move(text)});
    }

    const BoardDescription& board_;
    const std::map<std::string, std::string> board_pins_;
    std::string file_;
    std::map<std::string, Assigned> bits_;  // of the ports, in small letters
    std::size_t others_ = 0;
    Messages messages_;
};

}  // namespace

Messages pin_errors(const Project& project, const std::vector<Port>& ports) {
    return Pins{project, ports}.errors();
}

Messages pin_warnings(const Project& project, const std::vector<Port>& ports) {
    if (project.settings.empty() || project.is_for_other_device) return {};
    return Pins{project, ports}.warnings();
}

}  // namespace sim::project
