// engine.h - what ArmCore's files share: Unicorn's handle, the mappings, the inspectors.
#pragma once

#include <unicorn/unicorn.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "sim/cpu/arm_core.h"

namespace sim {

inline void check_uc(uc_err error, const char* what) {
    if (error != UC_ERR_OK)
        throw std::runtime_error{std::string{"unicorn: "} + what + ": " + uc_strerror(error)};
}

struct ArmCore::Engine {
    struct Ram {  // `bytes` are the owner's
        std::uint32_t base;
        std::uint64_t size;
        std::uint8_t* bytes;
    };
    struct Window {  // to the bus: the argument of its hooks
        ArmCore* core;
        std::uint32_t bus_base;
        std::uint32_t base;
        std::uint64_t size;
    };

    uc_engine* uc = nullptr;
    ArmBus& bus;
    uc_hook watch_hook = 0;
    ArmProbe* probe = nullptr;
    std::unordered_set<std::uint32_t> probed;
    ArmTally* tally = nullptr;
    ArmWatch* watch = nullptr;
    ArmTally::Run tallied{0, 0, 0, 0};  // the instruction in progress
    int exception = 0;                  // number that Unicorn gave, or 0
    bool aborted = false;
    bool watched = false;  // the access in progress must not be done
    std::vector<Ram> ram;
    std::vector<std::unique_ptr<Window>> windows;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> forbidden;  // to fetch from: base and size

    struct Hooks;
    explicit Engine(ArmBus& bus_) : bus{bus_} {
        check_uc(uc_open(UC_ARCH_ARM, UC_MODE_ARM, &uc), "uc_open");
        check_uc(uc_ctl_set_cpu_model(uc, UC_CPU_ARM_CORTEX_A9), "cpu model");
    }
    ~Engine() { uc_close(uc); }

    const Ram* find(std::uint32_t address, std::size_t bytes) const {
        for (const Ram& area : ram) {
            const std::uint32_t offset = address - area.base;
            if (offset < area.size && bytes <= area.size - offset) return &area;
        }
        return nullptr;
    }
};

}  // namespace sim
