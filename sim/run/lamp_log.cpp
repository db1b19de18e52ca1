#include "sim/run/lamp_log.h"

#include <fmt/format.h>

#include "sim/scenario/seven_segment.h"

namespace sim {

namespace {

using Fields = RunReport::Shown::Fields;

std::string bits(std::uint16_t ledr) { return fmt::format("{:010b}", ledr); }

Fields ledr_fields(std::uint16_t ledr) { return {{"lit", bits(ledr)}}; }

Fields hex_fields(std::uint64_t hex) {
    const HexSegments digits = segments_of(hex);
    std::string all;
    for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit)
        all += fmt::format("{}{:02X}", all.empty() ? "" : " ", *digit);
    return {{"text", hex_text(digits)}, {"segments", all}};
}

Fields led_fields(bool lit) { return {{"lit", lit ? "1" : "0"}}; }

std::string jp_text(std::uint64_t pins) { return fmt::format("0x{:08X}", bits_of_pins(pins)); }

std::string gpio_text(std::uint64_t pins) { return fmt::format("0x{:09X}", pins); }

Fields jp_fields(const Lamps::Header& header) {
    return {{"levels", jp_text(header.levels)}, {"outputs", jp_text(header.outputs)}};
}

Fields gpio_fields(const Lamps::Header& header) {
    return {{"levels", gpio_text(header.levels)}, {"outputs", gpio_text(header.outputs)}};
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
    gpio_0_.show(time_s, lamps.gpio[0]);
    gpio_1_.show(time_s, lamps.gpio[1]);
}

std::vector<RunReport::Shown> LampLog::shown(Headers headers) const {
    const bool jp = headers == Headers::JP;
    const auto fields = jp ? jp_fields : gpio_fields;
    return {shown_of("ledr", ledr_, ledr_fields), shown_of("hex", hex_, hex_fields),
            shown_of("hps_led", hps_led_, led_fields),
            shown_of(jp ? "jp1" : "gpio_0", gpio_0_, fields),
            shown_of(jp ? "jp2" : "gpio_1", gpio_1_, fields)};
}

std::string LampLog::text(Headers headers) const {
    std::string text;
    const auto add = [&text](bool there, const std::string& what) {
        if (there) text += (text.empty() ? "" : ", ") + what;
    };
    add(ledr_.now() != 0, "LEDR " + bits(ledr_.now()));
    add(hex_.now() != 0, "HEX \"" + hex_text(segments_of(hex_.now())) + "\"");
    add(hps_led_.now(), "the HPS's LED is lit");
    const bool jp = headers == Headers::JP;
    const auto as_text = jp ? jp_text : gpio_text;
    for (const auto& [name, header] :
         {std::pair{jp ? "JP1" : "GPIO_0", gpio_0_.now()}, {jp ? "JP2" : "GPIO_1", gpio_1_.now()}})
        add(header.outputs != 0,
            fmt::format("{} puts {} on {}", name, as_text(header.levels & header.outputs),
                        as_text(header.outputs)));
    return text;
}

}  // namespace sim
