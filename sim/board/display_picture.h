// display_picture.h - the picture on a display among the parts, as a person sees it
#pragma once

#include <cstdint>
#include <vector>

namespace sim {

struct DisplayPicture {
    unsigned width, height;
    std::vector<std::uint32_t> pixels;  // 0x00RRGGBB, from the top left

    bool operator==(const DisplayPicture& o) const {
        return width == o.width && height == o.height && pixels == o.pixels;
    }
};

}  // namespace sim
