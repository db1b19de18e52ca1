// devices.h - the modules of a system as the processor's software names them
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/hps/pixel_buffer.h"
#include "sim/project/qsys/assembly.h"
#include "sim/project/qsys/interconnect.h"

namespace sim::project::qsys {

// What the processor reaches at one address.
struct Device {
    std::string instance, kind, slave;  // "led", "altera_avalon_pio", "s1"
    bool is_only_slave;                 // of its instance, at the processor's bridges
    std::uint32_t window;               // of the bridge: first address, of the processor
    std::uint64_t base, span;           // from there
    // Of the instance, at the processor's interrupt controller, from 72 on; in rising order.
    std::vector<unsigned> interrupts;
    // "VENDOR,NAME-VERSION", by which a kernel's driver finds it: embeddedsw.dts.* of its _hw.tcl.
    std::vector<std::string> compatible;
    std::string group;                          // embeddedsw.dts.group: "gpio"
    std::map<std::string, std::string> macros;  // embeddedsw.CMacro.NAME of its _hw.tcl
};

// In the order of their addresses.
std::vector<Device> devices_of(const Assembly& assembly, const std::vector<Place>& map);

// Of the University Program's pixel buffer DMA, if the processor reaches its memory, or of a frame
// reader; of several the first.
std::optional<PixelBuffer> pixel_buffer_of(const Assembly& assembly, const std::vector<Place>& map);

// hps_0.h, with the macros that the vendor's sopc-create-header-files gives.
std::string header_text(const std::string& system, const std::vector<Device>& devices);

// Nodes for Linux' device tree; their addresses are the processor's.
std::string device_tree_text(const std::vector<Device>& devices);

}  // namespace sim::project::qsys
