// system_id.h - is this the bitstream that the firmware was built for?
#pragma once

#include "hal/mmio.h"
#include "regmap.h"

namespace hal {

inline bool system_id_matches(Mmio& io) {
    return io.read(regmap::SYSID_ID) == regmap::SYSID_ID_RESET &&
           io.read(regmap::SYSID_HASH) == regmap::REGMAP_HASH;
}

}  // namespace hal
