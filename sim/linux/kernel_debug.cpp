// kernel_debug.cpp - LinuxKernel's threads and modules, as a debugger sees them
#include <algorithm>

#include <fmt/format.h>

#include "sim/linux/kernel.h"

namespace sim {

std::vector<ArmThread> LinuxKernel::thread_list() const {
    std::vector<ArmThread> list;
    for (const LinuxThread* const thread : threads()) {
        const LinuxProcess& process = thread->process;
        std::string name = thread->name, state;
        if (name.empty()) name = process.command.substr(process.command.rfind('/') + 1);
        if (process.module) name = "[" + name + "]";
        if (!process.module && process.number != LinuxProcess::FIRST)
            state = fmt::format("process {}, ", process.number);
        if (thread == running_)
            state += "runs";
        else if (process.stopped)
            state += "stopped by a signal";
        else if (thread->wait)
            state += "waits for " + awaited(*thread);
        else
            state += "waits for its turn";
        list.push_back({static_cast<unsigned>(thread->number), std::move(name), std::move(state)});
    }
    return list;
}

unsigned LinuxKernel::running_thread() const {
    return running_ ? static_cast<unsigned>(running_->number) : 0;
}

ArmRegisters* LinuxKernel::saved_registers(unsigned number) {
    LinuxThread* const thread = number ? thread_of(number) : nullptr;
    return thread == running_ ? nullptr : thread;
}

void LinuxKernel::show_memory_of(unsigned number) {
    AddressSpace* const present = shown_ ? shown_ : attached_;
    AddressSpace* wanted = attached_;
    if (number != 0) {
        const LinuxThread* const thread = thread_of(number);
        if (!thread) return;
        const LinuxProcess* const process =
            thread->process.module ? process_below(*thread) : &thread->process;
        if (process) wanted = process->memory.get();
    }
    if (wanted == present) return;
    if (present) present->detach();
    if (wanted) wanted->attach();
    shown_ = wanted == attached_ ? nullptr : wanted;
}

std::vector<ArmModule> LinuxKernel::module_list() const {
    std::vector<ArmModule> list;
    std::error_code error;
    for (const auto& module : modules_)
        list.push_back({module->name, std::filesystem::is_regular_file(module->elf, error)
                                          ? module->elf
                                          : std::filesystem::path{}});
    return list;
}

}  // namespace sim
