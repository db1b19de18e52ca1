// kernel_groups.cpp - LinuxKernel's groups and sessions of processes
#include <algorithm>
#include <cerrno>

#include "sim/linux/kernel.h"

namespace sim {

LinuxKernel::Result LinuxKernel::sys_getpgrp(const Arguments&) { return process_->group; }

LinuxKernel::Result LinuxKernel::sys_getpgid(const Arguments& a) {
    const LinuxProcess* const of =
        a[0] == 0 ? process_ : process_of(static_cast<std::int32_t>(a[0]));
    return of ? of->group : -ESRCH;
}

LinuxKernel::Result LinuxKernel::sys_getsid(const Arguments& a) {
    const LinuxProcess* const of =
        a[0] == 0 ? process_ : process_of(static_cast<std::int32_t>(a[0]));
    return of ? of->session : -ESRCH;
}

// Of itself or a child, which must be of the same session and not lead it.
LinuxKernel::Result LinuxKernel::sys_setpgid(const Arguments& a) {
    const auto of = static_cast<std::int32_t>(a[0]), wish = static_cast<std::int32_t>(a[1]);
    if (wish < 0) return -EINVAL;
    LinuxProcess* const process = of == 0 ? process_ : process_of(of);
    if (!process || (process != process_ && process->parent != process_->number)) return -ESRCH;
    if (process->session != process_->session || process->session == process->number) return -EPERM;
    const int group = wish == 0 ? process->number : wish;
    const bool is_there = group == process->number ||
                          std::any_of(processes_.begin(), processes_.end(), [&](const auto& other) {
                              return other->group == group && other->session == process->session;
                          });
    if (!is_there) return -EPERM;
    process->group = group;
    return 0;
}

LinuxKernel::Result LinuxKernel::sys_setsid(const Arguments&) {
    const bool leads = std::any_of(processes_.begin(), processes_.end(), [this](const auto& other) {
        return other->group == process_->number;
    });
    if (leads) return -EPERM;
    process_->group = process_->session = process_->number;
    return process_->number;
}

}  // namespace sim
