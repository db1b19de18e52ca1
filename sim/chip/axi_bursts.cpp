#include "sim/chip/axi_bursts.h"

#include <algorithm>

namespace sim {

namespace {

constexpr unsigned BEATS = 16, BOUNDARY = 0x1000;
constexpr unsigned WORD = 4, L3_BYTES = 8, STORE_BUFFER_LINE = 32;

// Of the smallest aligned piece around these bytes, at most `most`.
unsigned piece_around(std::uint32_t address, unsigned bytes, unsigned most) {
    unsigned size = 1;
    while (size < most && address / size != (address + bytes - 1) / size) size *= 2;
    return size;
}

class Splitter {
public:
    Splitter(bool write, const AxiAttributes& how, unsigned width)
        : write_{write}, how_{how}, width_{width} {}

    std::vector<AxiBurst> run(std::uint32_t address, unsigned bytes) {
        if (how_.fixed) {
            fixed(address, bytes, how_.beat_bytes);
        } else {
            const unsigned step = reach();
            for (unsigned done = 0; done < bytes;) {
                const std::uint32_t at = address + done;
                const unsigned now = std::min(bytes - done, step - at % step);
                master_burst(at, done, now);
                done += now;
            }
        }
        return std::move(bursts_);
    }

private:
    bool is_normal() const { return how_.cache & 2; }

    // Bytes of the aligned block that the master's burst does not leave.
    unsigned reach() const {
        if (how_.master == AxiAttributes::Master::DMA || !write_) return BOUNDARY;
        return is_normal() ? STORE_BUFFER_LINE : L3_BYTES;
    }

    // Before the bridge: one burst of the processor's or the DMA controller's.
    void master_burst(std::uint32_t address, unsigned first, unsigned bytes) {
        unsigned size = how_.beat_bytes;
        if (how_.master == AxiAttributes::Master::PROCESSOR)
            size = bytes <= WORD ? piece_around(address, bytes, L3_BYTES)
                   : is_normal() ? L3_BYTES
                                 : WORD;
        const bool is_one = address / size == (address + bytes - 1) / size;
        if (size > width_ || (is_normal() && width_ != L3_BYTES && !is_one))
            size = piece_around(address, bytes, width_);
        incrementing(address, first, bytes, size);
    }

    void incrementing(std::uint32_t address, unsigned first, unsigned bytes, unsigned size) {
        for (unsigned done = 0; done < bytes;) {
            const std::uint32_t at = address + done;
            const unsigned now = std::min(bytes - done, BEATS * size - at % size);
            const unsigned beats = (at % size + now + size - 1) / size;
            bursts_.push_back({at, beats, size, false, first + done, now});
            done += now;
        }
    }

    // A word wider than the bus becomes a burst of its parts, each time.
    void fixed(std::uint32_t address, unsigned bytes, unsigned size) {
        const unsigned step = size > width_ ? size : BEATS * size;
        for (unsigned done = 0; done < bytes; done += step) {
            const unsigned now = std::min(bytes - done, step);
            if (size > width_)
                incrementing(address, done, now, width_);
            else
                bursts_.push_back({address, now / size, size, true, done, now});
        }
    }

    const bool write_;
    const AxiAttributes& how_;
    const unsigned width_;
    std::vector<AxiBurst> bursts_;
};

}  // namespace

std::vector<AxiBurst> axi_bursts(std::uint32_t address, unsigned bytes, bool write,
                                 const AxiAttributes& how, unsigned width) {
    return Splitter{write, how, width}.run(address, bytes);
}

AxiBurst long_burst(std::uint32_t address, unsigned bytes, unsigned first) {
    const std::uint32_t at = address + first;
    const unsigned now =
        std::min({bytes - first, BEATS * WORD - at % WORD, BOUNDARY - at % BOUNDARY});
    const unsigned size = now == 1 ? 1 : now == 2 && at % 2 == 0 ? 2 : WORD;
    return {at, (at + now - 1) / size - at / size + 1, size, false, first, now};
}

}  // namespace sim
