#include "sim/chip/de10_lite_picture.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "de10_lite.h"

namespace sim {

namespace {

namespace lite = regmap::de10_lite;

constexpr unsigned WIDTH = 160, HEIGHT = 120, LINES_OF_A_ROW = 4, AHEAD = 2;
constexpr unsigned CLOCKS_OF_A_LINE = 800, LINES = 525, SHOWN = HEIGHT * LINES_OF_A_ROW;
constexpr unsigned RESET_CLOCKS = 8;  // of the fabric, before the beam begins
constexpr std::uint32_t PITCH = 1 << 9, FABRIC_PITCH = 1 << 10;

}  // namespace

std::uint32_t De10LitePicture::in_fabric(std::uint32_t offset) {
    return offset / PITCH * 2 * FABRIC_PITCH + offset % PITCH / 2 * 4;
}

De10LitePicture::De10LitePicture(const std::uint8_t* sdram, Write write)
    : sdram_{sdram},
      write_{std::move(write)},
      memory_(MEMORY_SIZE),
      front_{lite::PIXEL_BUFFER_RESET},
      back_{lite::PIXEL_BACK_BUFFER_RESET} {}

void De10LitePicture::read(std::uint32_t offset, std::uint8_t* data, unsigned bytes) const {
    std::memcpy(data, &memory_[offset], bytes);
}

void De10LitePicture::write(std::uint32_t offset, const std::uint8_t* data, unsigned bytes) {
    std::memcpy(&memory_[offset], data, bytes);
    const std::uint32_t first = offset & ~1u;
    show(first, (offset + bytes + 1 - first) / 2);
}

bool De10LitePicture::is_direct() const { return front_ == lite::ONCHIP_BASE; }

// Of the picture on screen.  The controller reaches the two memories, and outside of them, as all
// masters, the SDRAM.
std::uint16_t De10LitePicture::pixel(std::uint32_t offset) const {
    const std::uint32_t address = front_ + offset;
    std::uint16_t pixel;
    if (address - lite::ONCHIP_BASE < MEMORY_SIZE)
        std::memcpy(&pixel, &memory_[(address - lite::ONCHIP_BASE) & ~1u], sizeof pixel);
    else
        std::memcpy(&pixel, sdram_ + (address % lite::SDRAM_SIZE & ~1u), sizeof pixel);
    return pixel;
}

void De10LitePicture::show(std::uint32_t offset, unsigned pixels) {
    for (unsigned n = 0; n < pixels; ++n, offset += 2) {
        const std::uint16_t two[] = {pixel(offset), pixel(offset)};
        std::uint8_t bytes[sizeof two];
        std::memcpy(bytes, two, sizeof two);
        for (const std::uint32_t row : {0u, FABRIC_PITCH})
            write_(in_fabric(offset) + row, bytes, sizeof bytes);
    }
}

void De10LitePicture::show_row(unsigned row) { show(row * PITCH, WIDTH); }

void De10LitePicture::ask(std::uint64_t clock) {
    if (!std::exchange(pending_, true)) asked_ = clock;
}

void De10LitePicture::seen(bool pending) {
    if (pending_ && !pending) swap();
}

void De10LitePicture::swap() {
    pending_ = false;
    std::swap(front_, back_);
    behind_ = true;
}

// At the end of a frame, and two rows ahead of each row.
void De10LitePicture::beam(std::size_t samples) {
    clock_ += samples;
    if (clock_ <= RESET_CLOCKS) return;
    const std::uint64_t beam = clock_ - RESET_CLOCKS;
    const auto now = static_cast<unsigned>(beam / CLOCKS_OF_A_LINE % LINES);
    while (line_ != now) {
        line_ = (line_ + 1) % LINES;
        if (line_ == SHOWN) {
            const std::uint64_t end = clock_ - (beam - SHOWN * CLOCKS_OF_A_LINE) %
                                                   (std::uint64_t{LINES} * CLOCKS_OF_A_LINE);
            if (pending_ && enabled_ && asked_ < end) swap();
            if (behind_ || !is_direct())
                for (unsigned row = 0; row < (is_direct() ? HEIGHT : AHEAD); ++row) show_row(row);
            behind_ = false;
        } else if (line_ < SHOWN && line_ % LINES_OF_A_ROW == 0 && !is_direct()) {
            const unsigned row = line_ / LINES_OF_A_ROW + AHEAD;
            if (row < HEIGHT) show_row(row);
        }
    }
}

}  // namespace sim
