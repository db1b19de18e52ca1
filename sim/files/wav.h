// wav.h - the sound of a run as 16-bit stereo WAV, written during the run
//
// The header's sample rate is the true rate rounded to whole hertz.  Silence at the start is
// counted, and written only when the first sound comes.  So a codec may change its rate before the
// first sound, and the silence still has the right length.  After the first sound a new rate begins
// a new file: audio.wav, audio-2.wav, audio-3.wav.  Each file appears whole when its part ends.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace sim {

class WavWriter {
public:
    explicit WavWriter(std::filesystem::path folder);  // which must exist
    ~WavWriter();                                      // without close() the open part is dropped
    WavWriter(const WavWriter&) = delete;
    WavWriter& operator=(const WavWriter&) = delete;

    // Sound that comes before the first rate_changed() waits in memory; more than 65,536 such
    // samples are a std::logic_error.
    void push(std::int16_t left, std::int16_t right);

    // A rate that rounds to the present one changes nothing.  1 to 384,000 Hz, else
    // std::invalid_argument.
    void rate_changed(double hz);

    // The files written, in order.  Sound without a known rate is in none of them.
    std::vector<std::filesystem::path> close();

private:
    struct Part;  // an open WAV file

    void open_part();
    void close_part();

    std::filesystem::path folder_;
    std::vector<std::filesystem::path> files_;
    int rate_hz_ = 0;                    // 0 = not known yet
    std::uint64_t silence_ = 0;          // samples before the part's first sound, not written yet
    std::vector<std::int16_t> waiting_;  // left, right: from the first sound on, while no rate
    std::unique_ptr<Part> part_;
};

}  // namespace sim
