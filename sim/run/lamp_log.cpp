#include "sim/run/lamp_log.h"

#include <fmt/format.h>

#include "sim/pins/header_pin.h"
#include "sim/scenario/seven_segment.h"

namespace sim {

namespace {

using Fields = RunReport::Shown::Fields;

constexpr unsigned ARDUINO = header_of(ChipWire::ARDUINO_IO);

std::string bits(std::uint32_t ledr) { return fmt::format("{:010b}", ledr); }

Fields ledr_fields(std::uint32_t ledr) { return {{"lit", bits(ledr)}}; }

Fields hex_fields(std::uint64_t hex) {
    const HexSegments digits = segments_of(hex);
    std::string all;
    for (unsigned n = digits_shown(digits); n-- > 0;)
        all += fmt::format("{}{:02X}", all.empty() ? "" : " ", digits[n]);
    return {{"text", hex_text(digits)}, {"segments", all}};
}

Fields led_fields(bool lit) { return {{"lit", lit ? "1" : "0"}}; }

std::string jp_text(std::uint64_t pins) { return fmt::format("0x{:08X}", bits_of_pins(pins)); }

std::string gpio_text(std::uint64_t pins) { return fmt::format("0x{:09X}", pins); }

std::string arduino_text(std::uint64_t pins) {
    return fmt::format("0x{:04X}", pins & pins_of(ChipWire::ARDUINO_IO));
}

// Header `which`, named as `headers` says.
struct HeaderName {
    const char *key, *name;
    std::string (*text)(std::uint64_t pins);
};

HeaderName header_name(unsigned which, LampLog::Headers headers) {
    const bool jp = headers == LampLog::Headers::JP;
    if (which == ARDUINO) return {"arduino_io", "ARDUINO_IO", arduino_text};
    if (which == 0)
        return jp ? HeaderName{"jp1", "JP1", jp_text} : HeaderName{"gpio_0", "GPIO_0", gpio_text};
    return jp ? HeaderName{"jp2", "JP2", jp_text} : HeaderName{"gpio_1", "GPIO_1", gpio_text};
}

template <class State, class ToFields>
RunReport::Shown shown_of(const char* name, const Changes<State>& changes, ToFields to_fields) {
    RunReport::Shown shown{name, to_fields(changes.now()), {}, changes.left_out()};
    for (const auto& [time_s, state] : changes.first())
        shown.changes.emplace_back(time_s, to_fields(state));
    return shown;
}

}  // namespace

void LampLog::show(const Lamps& lamps, double time_s) {
    ledr_.show(time_s, lamps.ledr);
    hex_.show(time_s, lamps.hex);
    hps_led_.show(time_s, lamps.hps_led);
    for (unsigned n = 0; n < HEADERS; ++n) headers_[n].show(time_s, lamps.gpio[n]);
}

std::vector<RunReport::Shown> LampLog::shown(Headers headers, bool has_arduino) const {
    std::vector<RunReport::Shown> all{shown_of("ledr", ledr_, ledr_fields),
                                      shown_of("hex", hex_, hex_fields),
                                      shown_of("hps_led", hps_led_, led_fields)};
    for (unsigned n = 0; n < HEADERS; ++n) {
        if (n == ARDUINO && !has_arduino) continue;
        const HeaderName header = header_name(n, headers);
        all.push_back(shown_of(header.key, headers_[n], [&](const Lamps::Header& now) {
            return Fields{{"levels", header.text(now.levels)},
                          {"outputs", header.text(now.outputs)}};
        }));
    }
    return all;
}

std::string LampLog::text(Headers headers) const {
    std::string text;
    const auto add = [&text](bool there, const std::string& what) {
        if (there) text += (text.empty() ? "" : ", ") + what;
    };
    add(ledr_.now() != 0, "LEDR " + bits(ledr_.now()));
    add(hex_.now() != 0, "HEX \"" + hex_text(segments_of(hex_.now())) + "\"");
    add(hps_led_.now(), "the HPS's LED is lit");
    for (unsigned n = 0; n < HEADERS; ++n) {
        const Lamps::Header now = headers_[n].now();
        const HeaderName header = header_name(n, headers);
        add(now.outputs != 0,
            fmt::format("{} puts {} on {}", header.name, header.text(now.levels & now.outputs),
                        header.text(now.outputs)));
    }
    return text;
}

}  // namespace sim
