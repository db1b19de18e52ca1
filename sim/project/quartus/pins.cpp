#include "sim/project/quartus/pins.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>

#include "sim/project/file_finder.h"

namespace sim::project {

namespace {

struct Assigned {
    std::string pin;
    Place place;
};

class Pins {
public:
    Pins(const Project& project, const std::vector<Port>& ports) {
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
            if (assigned.pin.empty()) continue;
            if (!is_of_package(assigned.pin)) {
                add(171016, assigned.place,
                    fmt::format("{} is assigned to {}, which the chip has not", name,
                                assigned.pin));
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

    Messages warnings(const std::map<std::string, std::string>& board_pins) {
        std::string open;
        std::size_t count = 0;
        for (const auto& [name, assigned] : bits_) {
            if (assigned.pin.empty()) {
                if (++count <= 3) open += (open.empty() ? "" : ", ") + name;
            } else if (board_pins.count(assigned.pin) == 0 && is_of_package(assigned.pin)) {
                add(171016, assigned.place,
                    fmt::format("{} is assigned to {}, where the board has nothing; Quartus "
                                "refuses that if it is no pin for signals",
                                name, assigned.pin));
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
    // PIN_A1 to PIN_AK30: the rows of balls have no letters that look like digits.
    static bool is_of_package(const std::string& pin) {
        constexpr std::string_view ROWS = "ABCDEFGHJKLMNPRTUVWY", PREFIX = "PIN_";
        constexpr std::size_t LAST_OF_TWO_LETTERS = 10;  // AA to AK
        constexpr unsigned long COLUMNS = 30;
        if (pin.compare(0, PREFIX.size(), PREFIX) != 0) return true;  // a bank or an edge
        std::size_t at = PREFIX.size();
        std::size_t row = at < pin.size() ? ROWS.find(pin[at++]) : std::string::npos;
        if (row == 0 && at < pin.size() && ROWS.find(pin[at]) != std::string::npos) {
            row = ROWS.find(pin[at++]);
            if (row >= LAST_OF_TWO_LETTERS) return false;
        }
        char* end = nullptr;
        const unsigned long column = std::strtoul(pin.c_str() + at, &end, 10);
        return row != std::string::npos && *end == '\0' && column >= 1 && column <= COLUMNS;
    }

    void add(unsigned number, const Place& place, std::string text) {
        messages_.push_back({number, place.file, place.line, std::move(text)});
    }

    std::string file_;
    std::map<std::string, Assigned> bits_;  // of the ports, in small letters
    std::size_t others_ = 0;
    Messages messages_;
};

}  // namespace

Messages pin_errors(const Project& project, const std::vector<Port>& ports) {
    return Pins{project, ports}.errors();
}

Messages pin_warnings(const Project& project, const std::vector<Port>& ports,
                      const std::map<std::string, std::string>& board_pins) {
    if (project.settings.empty() || project.is_for_other_device) return {};
    return Pins{project, ports}.warnings(board_pins);
}

}  // namespace sim::project
