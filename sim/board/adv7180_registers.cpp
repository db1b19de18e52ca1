#include "sim/board/adv7180_registers.h"

#include <utility>

namespace sim {

namespace {

constexpr std::uint8_t MAP = 0x0E, POWER = 0x0F, STATUS_1 = 0x10, IDENT = 0x11, STATUS_2 = 0x12,
                       STATUS_3 = 0x13, FIRST_OF_SUB_MAP = 0x40;
constexpr unsigned SUB_USR_EN = 0x20, RESET = 0x80;
constexpr std::uint8_t IN_LOCK = 0x01, LOST_LOCK = 0x02, FSC_LOCK = 0x04;  // status 1
constexpr std::uint8_t INST_HLOCK = 0x01, FREE_RUN = 0x10, STD_FLD_LEN = 0x20, INTERLACED = 0x40;

// Those that do not begin at 0.
constexpr std::pair<std::uint8_t, std::uint8_t> DEFAULTS[] = {
    {0x01, 0xC8}, {0x03, 0x0C},  {0x04, 0x45}, {0x07, 0x7F}, {0x08, 0x80}, {0x0C, 0x36},
    {0x0D, 0x7C}, {IDENT, 0x1E}, {0x14, 0x12}, {0x17, 0x01}, {0x18, 0x93}, {0x19, 0xF1},
    {0x27, 0x58}, {0x2B, 0xE1},  {0x2C, 0xAE}, {0x2D, 0xF4}, {0x2F, 0xF0}, {0x31, 0x12},
    {0x32, 0x41}, {0x33, 0x84},  {0x35, 0x02}, {0x37, 0x01}, {0x38, 0x80}, {0x39, 0xC0},
    {0x3A, 0x10}, {0x3D, 0x43},  {0x41, 0x01}, {0x4D, 0xEF}, {0x4E, 0x08}, {0x50, 0x08},
    {0x51, 0x24}, {0xB2, 0x1C},  {0xDC, 0xAC}, {0xDD, 0x4C}, {0xE1, 0x80}, {0xE2, 0x80},
    {0xE3, 0x80}, {0xE4, 0x80},  {0xE5, 0x25}, {0xE6, 0x04}, {0xE7, 0x63}, {0xE8, 0x65},
    {0xE9, 0x14}, {0xEA, 0x63},  {0xEB, 0x55}, {0xEC, 0x55}, {0xF4, 0x15}, {0xFB, 0x40},
    {0xFC, 0x04}};

bool is_status(std::uint8_t subaddress) { return subaddress >= STATUS_1 && subaddress <= STATUS_3; }

}  // namespace

void Adv7180Registers::reset() {
    main_ = {};
    sub_ = {};
    for (const auto& [subaddress, value] : DEFAULTS) main_[subaddress] = value;
}

std::uint8_t& Adv7180Registers::here() {
    return (main_[MAP] & SUB_USR_EN && at_ >= FIRST_OF_SUB_MAP ? sub_ : main_)[at_];
}

void Adv7180Registers::write(std::uint8_t value) {
    if (!is_status(at_)) here() = value;
    if (at_ == POWER && value & RESET) reset();
    ++at_;
}

std::uint8_t Adv7180Registers::read() {
    const std::uint8_t at = at_;
    std::uint8_t value = here();
    ++at_;
    if (at == STATUS_1) {
        value =
            static_cast<std::uint8_t>((locked_ ? IN_LOCK | FSC_LOCK : 0) | (lost_ ? LOST_LOCK : 0));
        lost_ = !locked_;
    } else if (at == STATUS_2) {
        value = 0;  // no copy protection
    } else if (at == STATUS_3) {
        value = locked_ ? INST_HLOCK | STD_FLD_LEN | INTERLACED : FREE_RUN;
    }
    return value;
}

void Adv7180Registers::signal(bool is_there) {
    locked_ = is_there;
    lost_ = lost_ || !is_there;
}

}  // namespace sim
