// video_modelines.h - the standard modes as X.org writes them: the second source of the tests
#pragma once

#include <cstdint>
#include <ostream>

namespace tb {

struct Modeline {
    double mhz;
    unsigned hdisp, hsyncstart, hsyncend, htotal;
    unsigned vdisp, vsyncstart, vsyncend, vtotal;
    bool hpositive, vpositive;

    std::uint64_t clocks() const { return std::uint64_t{htotal} * vtotal; }
    friend std::ostream& operator<<(std::ostream& to, const Modeline& m) {
        return to << m.hdisp << " x " << m.vdisp << " at " << m.mhz << " MHz";
    }
};

constexpr Modeline VGA{25.175, 640, 656, 752, 800, 480, 490, 492, 525, false, false};
constexpr Modeline SVGA{40, 800, 840, 968, 1056, 600, 601, 605, 628, true, true};

// clang-format off
constexpr Modeline MODELINES[] = {
    VGA,
    {31.5,   640,  664,  704,  832,   480,  489,  492,  520, false, false},
    {31.5,   640,  656,  720,  840,   480,  481,  484,  500, false, false},
    {36,     800,  824,  896, 1024,   600,  601,  603,  625, true,  true},
    SVGA,
    {50,     800,  856,  976, 1040,   600,  637,  643,  666, true,  true},
    {49.5,   800,  816,  896, 1056,   600,  601,  604,  625, true,  true},
    {65,    1024, 1048, 1184, 1344,   768,  771,  777,  806, false, false},
    {75,    1024, 1048, 1184, 1328,   768,  771,  777,  806, false, false},
    {74.25, 1280, 1390, 1430, 1650,   720,  725,  730,  750, true,  true},
    {108,   1280, 1328, 1440, 1688,  1024, 1025, 1028, 1066, true,  true},
    {25.175, 640,  656,  752,  800,   350,  387,  389,  449, true,  false},
    {25.175, 640,  656,  752,  800,   400,  412,  414,  449, false, true},
    {28.322, 720,  738,  846,  900,   400,  412,  414,  449, false, true},
    {56.25,  800,  832,  896, 1048,   600,  601,  604,  631, true,  true},
    {85.5,  1366, 1436, 1579, 1792,   768,  771,  774,  798, true,  true},
    {106.5, 1440, 1520, 1672, 1904,   900,  903,  909,  934, false, true},
    {162,   1600, 1664, 1856, 2160,  1200, 1201, 1204, 1250, true,  true},
    {146.25, 1680, 1784, 1960, 2240, 1050, 1053, 1059, 1089, false, true},
    {148.5, 1920, 2008, 2052, 2200,  1080, 1084, 1089, 1125, true,  true},
};
// clang-format on

}  // namespace tb
