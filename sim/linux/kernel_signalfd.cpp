// kernel_signalfd.cpp - LinuxKernel's calls for signals that a program reads as from a file
#include <cerrno>
#include <csignal>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"
#include "sim/linux/signal_file.h"

namespace sim {

LinuxKernel::Result LinuxKernel::sys_signalfd4(const Arguments& a) {
    constexpr std::uint32_t A_NEW_ONE = 0xFFFFFFFF;
    std::uint64_t mask;
    if (a[2] != sizeof mask) return -EINVAL;
    if (!memory().read(a[1], &mask, sizeof mask)) return -EFAULT;
    if (a[3] & ~(arm_open::NONBLOCK | arm_open::CLOEXEC)) return -EINVAL;
    mask &= ~(LinuxSignals::bit(SIGKILL) | LinuxSignals::bit(SIGSTOP));
    if (a[0] == A_NEW_ONE) {
        const LinuxSignalFile::Caller caller{
            [this] {
                const LinuxThread& thread = this->caller();
                return thread.signals.pending.set() | thread.process.pending.set();
            },
            [this] {
                const LinuxThread& thread = this->caller();
                return thread.signals.pending.added() + thread.process.pending.added();
            },
            [this](std::uint64_t set) { return take_signal(this->caller(), ~set); }};
        return files().add(std::make_shared<LinuxSignalFile>(caller, mask), a[3] | arm_open::RDWR);
    }
    const int fd = static_cast<int>(a[0]);
    if (files().flags(fd) < 0) return -EBADF;
    auto* const file = dynamic_cast<LinuxSignalFile*>(files().device(fd));
    if (!file) return -EINVAL;
    file->mask = mask;
    changed_ = true;
    return fd;
}

LinuxKernel::Result LinuxKernel::sys_signalfd(const Arguments& a) {
    return sys_signalfd4({a[0], a[1], a[2]});
}

}  // namespace sim
