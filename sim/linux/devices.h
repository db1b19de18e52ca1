// devices.h - small files of the kernel's own: /dev/null and its kind, texts of /proc and /sys,
// /dev/shm, eventfd, /dev/fb0.
//
// /dev/fb0 is the University Program's pixel buffer: of the DE1-SoC Computer 320 x 240 pixels of 16
// bits, in lines of 1024 bytes, in the FPGA's on-chip memory.  Of a project's system it is that, or
// a frame reader's.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "sim/hps/pixel_buffer.h"
#include "sim/linux/device.h"

namespace sim::devices {

std::shared_ptr<LinuxDevice> null();
std::shared_ptr<LinuxDevice> zero(bool full);                             // /dev/full
std::shared_ptr<LinuxDevice> random(std::function<std::uint8_t()> next);  // /dev/urandom
std::shared_ptr<LinuxDevice> text(const std::string& path, std::string contents);
std::shared_ptr<LinuxDevice> shared(std::shared_ptr<SharedMemory> memory);  // of /dev/shm
std::shared_ptr<LinuxDevice> event(std::uint64_t value, bool as_semaphore);
// A word on the bus; false: refused.
using WordAccess = std::function<bool(bool write, std::uint32_t address, std::uint32_t& value)>;
std::shared_ptr<LinuxDevice> framebuffer(const PixelBuffer& pixels, WordAccess access);

FileStatus status_of_text();
FileStatus status_of_shared(const SharedMemory& memory);

}  // namespace sim::devices
