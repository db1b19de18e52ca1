// adv7180_registers.h - the registers of the video decoder ADV7180, as a program reads and writes
// them over I2C
//
//   write   0x40, subaddress, value, value ...      the subaddress counts up
//   read    0x40, subaddress, START, 0x41, value, value ...
//
// Bit 5 of 0x0E (SUB_USR_EN) puts the interrupts' and the data slicer's map in the place of the
// subaddresses from 0x40 on; it begins with zeros.  Bit 7 of 0x0F resets all.  Status is what the
// signal is: one of 525 lines, interlaced, NTSC, or none.  LOST_LOCK stays until 0x10 is read.
//
// Source: Analog Devices' ADV7180 datasheet, main register map; IDENT is that of the 32-lead
// package, which the board has.
#pragma once

#include <array>
#include <cstdint>

namespace sim {

class Adv7180Registers {
public:
    Adv7180Registers() { reset(); }

    void select(std::uint8_t subaddress) { at_ = subaddress; }
    void write(std::uint8_t value);
    std::uint8_t read();

    // Whether there is a signal at the input, from now on.
    void signal(bool is_there);

    // Of a default register, whatever map is chosen.
    std::uint8_t main(std::uint8_t subaddress) const { return main_[subaddress]; }

private:
    void reset();
    std::uint8_t& here();

    std::array<std::uint8_t, 256> main_{}, sub_{};
    std::uint8_t at_ = 0;
    bool locked_ = false, lost_ = true;
};

}  // namespace sim
