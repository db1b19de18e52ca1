// de10_lite_picture.h - the DE10-Lite Computer's picture of 160 x 120 on a fabric that shows 320 x
// 240
//
//   on-chip memory, 64 KB: (x, y) at y << 9 | x << 1        the fabric's, 256 KB: y << 10 | x << 1
//
// A pixel is four of the fabric's, so both are 4 x 4 of the monitor's.  While the picture is at the
// beginning of the on-chip memory, what is written there is shown at once.  Elsewhere, as in the
// SDRAM, its rows are copied as the beam comes, two of them (8 lines, 0.26 ms) ahead.
//
// The controller's two addresses are here.  When they change over, and whether they still have to,
// the fabric's own controller says, whose two addresses are one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace sim {

class De10LitePicture {
public:
    static constexpr std::uint32_t MEMORY_SIZE = 0x10000;

    // Writes into the fabric's on-chip memory, in no time.
    using Write = std::function<void(std::uint32_t offset, const std::uint8_t* data, unsigned)>;
    // `sdram`: the chip's 64 MB.
    De10LitePicture(const std::uint8_t* sdram, Write write);

    // Where the fabric's on-chip memory has the first byte of a pixel's four, by its offset here.
    static std::uint32_t in_fabric(std::uint32_t offset);

    // The on-chip memory, at an offset; a caller stays within its 64 KB.
    void read(std::uint32_t offset, std::uint8_t* data, unsigned bytes) const;
    void write(std::uint32_t offset, const std::uint8_t* data, unsigned bytes);

    std::uint32_t front() const { return front_; }
    std::uint32_t back() const { return back_; }
    void set_back(std::uint32_t address) { back_ = address; }

    // A swap was asked for in this clock of the fabric.
    void ask(std::uint64_t clock);
    // The fabric has, or has not, done it: seen by the program.
    void seen(bool pending);
    // Whether both controllers are on, without which there is no swap.
    void enable(bool on) { enabled_ = on; }

    // The fabric's beam has come so many samples further.
    void beam(std::size_t samples);

private:
    bool is_direct() const;
    std::uint16_t pixel(std::uint32_t offset) const;
    void show(std::uint32_t offset, unsigned pixels);
    void show_row(unsigned row);
    void swap();

    const std::uint8_t* const sdram_;
    Write write_;
    std::vector<std::uint8_t> memory_;
    std::uint32_t front_, back_;
    bool pending_ = false, enabled_ = true, behind_ = false;
    std::uint64_t asked_ = 0, clock_ = 0;
    unsigned line_ = 0;  // of the beam
};

}  // namespace sim
