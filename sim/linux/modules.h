// modules.h - kernel modules that are loaded: requests to them, files and interrupts of theirs.
//
// A module is a process in the kernel's addresses (KERNEL_BASE, elf.h), made by `de1sim link` of C
// files and of sw/kmod.  It calls the kernel by KMOD_CALL and is called by requests: see
// sw/kmod/kmod_calls.h.  A request runs in a thread of the module, with the memory of the program's
// process below it and its share of the processor, so that it takes the time of the program.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/linux/device.h"
#include "sim/linux/process.h"
#include "sw/kmod/kmod_calls.h"

namespace sim {

struct ModuleRequest {
    kmod_operation operation;
    std::uint32_t file = 0, flags = 0;
    std::uint32_t arguments[3] = {};
    LinuxThread* thread = nullptr;    // that waits for the result; or none
    LinuxProcess* process = nullptr;  // whose memory the module reaches; or none
    // What the program gets for a result; without a value it waits for something else.
    std::function<std::optional<std::int64_t>(std::int64_t)> finish{};
};

struct KernelModule {
    struct File {
        std::string path;
        std::uint32_t mode, number;  // type and permissions; of a device, as dev_t of the kernel
    };

    std::string name;
    std::filesystem::path elf{};  // on the host, for lines of its sources
    std::unique_ptr<LinuxProcess> process{};
    std::deque<std::shared_ptr<ModuleRequest>> requests{};  // that no thread has yet
    std::map<LinuxThread*, std::shared_ptr<ModuleRequest>> served{};
    std::vector<LinuxThread*> idle{};  // that wait for a request
    std::map<std::uint32_t, File> files{};
    std::optional<int> initialised{};  // the init functions' result
    std::function<void(int)> on_initialised{};
    unsigned open_files = 0;

    bool is_busy() const { return !requests.empty() || !served.empty(); }
};

// A device node of a module's file.
struct ModuleNode {
    KernelModule* module;
    std::uint32_t id, mode, number;
};

// An open file of a module; what is done with it is done by requests (LinuxKernel::request()).
class ModuleFile final : public LinuxDevice, public std::enable_shared_from_this<ModuleFile> {
public:
    static constexpr int NOBODY = 0;

    ModuleFile(KernelModule& of, std::uint32_t number, std::string path, FileStatus status,
               std::function<void(ModuleFile&)> on_close, std::function<void(ModuleFile&)> on_poll)
        : module{of},
          id{number},
          path_{std::move(path)},
          status_{status},
          on_close_{std::move(on_close)},
          on_poll_{std::move(on_poll)} {
        ++module.open_files;
    }
    ~ModuleFile() override {
        --module.open_files;
        on_close_(*this);
    }
    FileStatus status() const override { return status_; }
    std::string name() const override { return path_; }
    // What the module's poll() has returned; UNKNOWN while it has not answered.
    unsigned can_do() const override {
        if (!events_ && !asked_) {
            asked_ = true;
            on_poll_(const_cast<ModuleFile&>(*this));
        }
        return events_.value_or(UNKNOWN);
    }
    void look_again() override {
        events_.reset();
        changed_ = asked_;
    }
    void polled(std::uint32_t events) {
        constexpr std::uint32_t IN = 0x41, PRI = 2, OUT = 0x104, ERROR = 8, HUNG = 0x10;
        events_ = (events & IN ? READ : 0) | (events & OUT ? WRITE : 0) |
                  (events & HUNG ? HUNG_UP : 0) | (events & ERROR ? BROKEN : 0) |
                  (events & PRI ? PRIORITY : 0);
        asked_ = false;
        if (std::exchange(changed_, false)) events_.reset();
    }

    KernelModule& module;
    const std::uint32_t id;      // of the module's struct file
    int owner = NOBODY;          // the process that its signals go to
    bool sends_signals = false;  // O_ASYNC

private:
    const std::string path_;
    const FileStatus status_;
    std::function<void(ModuleFile&)> on_close_, on_poll_;
    mutable std::optional<unsigned> events_;
    mutable bool asked_ = false;
    bool changed_ = false;  // since it was asked
};

// An interrupt that a module has requested, or the kernel itself.
struct ModuleInterrupt {
    KernelModule* module;  // or nullptr
    std::string name;
    bool enabled = true, pending = false;
    LinuxThread* waiting = nullptr;  // the handler's
    LinuxThread* running = nullptr;  // the handler's, since this time
    std::uint64_t since_ns = 0;
    std::uint64_t count = 0;
};

}  // namespace sim
