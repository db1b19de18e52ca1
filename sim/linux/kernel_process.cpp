// kernel_process.cpp - LinuxKernel's calls about the process itself: what it is, its limits
#include <algorithm>
#include <cerrno>
#include <cstring>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

constexpr std::uint32_t LIMITS = 16, LIMIT_STACK = 3, LIMIT_FILES = 7, LIMIT_QUEUES = 12;
constexpr std::uint64_t NO_LIMIT = ~std::uint64_t{0};

std::uint64_t limit_of(std::uint32_t resource) {
    if (resource == LIMIT_STACK) return 8 << 20;
    if (resource == LIMIT_QUEUES) return MessageQueues::ALL_BYTES;
    return resource == LIMIT_FILES ? 1024 : NO_LIMIT;
}

}  // namespace

LinuxKernel::Result LinuxKernel::sys_uname(const Arguments& a) {
    constexpr std::size_t FIELD = 65;
    char names[6 * FIELD] = {};
    const char* const values[6] = {"Linux", "de1soc", "6.1.0", "#1", "armv7l", "(none)"};
    for (std::size_t i = 0; i < 6; ++i) std::strcpy(names + i * FIELD, values[i]);
    return memory().write(a[0], names, sizeof names) ? 0 : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_getrandom(const Arguments& a) {
    std::uint8_t* to = memory().bytes(a[0], a[1], arm_access::WRITE);
    if (!to) return -EFAULT;
    std::generate_n(to, a[1], [this] { return random_byte(); });
    return a[1] & 0x7FFFFFFF;
}

LinuxKernel::Result LinuxKernel::sys_prlimit64(const Arguments& a) {
    if (a[1] >= LIMITS) return -EINVAL;
    const std::uint64_t limits[2] = {limit_of(a[1]), limit_of(a[1])};
    return a[3] == 0 || memory().write(a[3], limits, sizeof limits) ? 0 : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_getrlimit(const Arguments& a) {
    if (a[0] >= LIMITS) return -EINVAL;
    const auto limit = static_cast<std::uint32_t>(limit_of(a[0]));
    const std::uint32_t limits[2] = {limit, limit};
    return memory().write(a[1], limits, sizeof limits) ? 0 : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_getrusage(const Arguments& a) {
    const std::uint64_t us = used_ns(*process_) / 1000;
    const std::uint32_t usage[18] = {static_cast<std::uint32_t>(us / 1'000'000),
                                     static_cast<std::uint32_t>(us % 1'000'000)};
    return memory().write(a[1], usage, sizeof usage) ? 0 : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_sysinfo(const Arguments& a) {
    std::uint32_t info[16] = {};  // uptime, loads, RAM in all and free, ..., bytes of its unit
    info[0] = static_cast<std::uint32_t>(now_ns() / 1'000'000'000);
    info[4] = info[5] = static_cast<std::uint32_t>(AddressSpace::RAM);
    info[10] = 1;
    info[13] = 1;
    return memory().write(a[0], info, sizeof info) ? 0 : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_done(const Arguments&) { return 0; }
LinuxKernel::Result LinuxKernel::sys_getpid(const Arguments&) { return process_->number; }
LinuxKernel::Result LinuxKernel::sys_getppid(const Arguments&) { return process_->parent; }

}  // namespace sim
