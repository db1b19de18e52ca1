#include "sim/board/nec_frame.h"

namespace sim {

namespace {

constexpr std::uint32_t CUSTOM_CODE = 0x6B86;
constexpr std::uint32_t LEAD_LIGHT_NS = 9'000'000, LEAD_DARK_NS = 4'500'000, UNIT_NS = 562'500;

struct Button {
    const char* name;
    std::uint8_t code;
};

constexpr Button BUTTONS[] = {
    {"0", 0x00},
    {"1", 0x01},
    {"2", 0x02},
    {"3", 0x03},
    {"4", 0x04},
    {"5", 0x05},
    {"6", 0x06},
    {"7", 0x07},
    {"8", 0x08},
    {"9", 0x09},
    {"a", 0x0F},
    {"b", 0x13},
    {"c", 0x10},
    {"power", 0x12},
    {"menu", 0x11},
    {"return", 0x17},
    {"play", 0x16},
    {"adjust-left", 0x14},
    {"adjust-right", 0x18},
    {"mute", 0x0C},
    {"channel-up", 0x1A},
    {"channel-down", 0x1E},
    {"volume-up", 0x1B},
    {"volume-down", 0x1F},
};

}  // namespace

std::optional<std::uint8_t> remote_button(const std::string& name) {
    for (const Button& button : BUTTONS)
        if (name == button.name) return button.code;
    return std::nullopt;
}

std::vector<std::string> remote_buttons() {
    std::vector<std::string> names;
    for (const Button& button : BUTTONS) names.emplace_back(button.name);
    return names;
}

std::vector<std::uint32_t> nec_frame(std::uint8_t button) {
    const std::uint32_t inverted = ~button & 0xFFu;
    const std::uint32_t bits = inverted << 24 | std::uint32_t{button} << 16 | CUSTOM_CODE;
    std::vector<std::uint32_t> times{LEAD_LIGHT_NS, LEAD_DARK_NS};
    for (unsigned bit = 0; bit < 32; ++bit) {
        times.push_back(UNIT_NS);
        times.push_back(bits >> bit & 1 ? 3 * UNIT_NS : UNIT_NS);
    }
    times.push_back(UNIT_NS);
    return times;
}

}  // namespace sim
