// tone.h - what a stretch of samples sounds like: a tone, or silence
#pragma once

#include <cstdint>
#include <vector>

namespace sim {

struct Tone {
    double hz = 0;             // the strongest frequency; 0 when there is none
    double level_dbfs = -200;  // of that frequency; a full-scale sine is 0
    double share = 0;          // of the energy, 0 to 1, that lies at that frequency
};

// Accurate to 0.5 % for a steady tone of ten or more periods.  The mean is subtracted first.  Fewer
// than 32 samples, or equal ones, are no tone.
Tone analyse_tone(const std::vector<std::int16_t>& samples, double rate_hz);

// True when the strongest frequency is `hz` to within the fraction `within` (0.03 = 3 %), has half
// of the energy or more (a square wave's fundamental has 0.81), and no eighth of the stretch is
// quieter than -60 dBFS: a tone that begins late or ends early does not fill the stretch.
bool is_tone(const std::vector<std::int16_t>& samples, double rate_hz, double hz, double within);

// True when every sample is exactly 0.
bool is_silence(const std::vector<std::int16_t>& samples);

}  // namespace sim
