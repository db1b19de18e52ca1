// register_table.h - a block of registers that a table describes: they keep what programs write
// into their writable bits, and do nothing more.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "sim/hps/registers.h"

namespace sim {

struct TableRegister {
    std::uint32_t offset, value;          // after the preloader
    std::uint32_t writable = 0xFFFFFFFF;  // bits that keep what is written
    std::uint32_t clears = 0;             // bits that a written 1 clears
};

class RegisterTable : public Registers {
public:
    // A written value differed from the register's; called after the write.
    using Changed = std::function<void(std::uint32_t offset)>;

    // Offsets that the table does not have read 0 and lose what is written.
    RegisterTable(
        const sc_core::sc_module_name& module_name, std::vector<TableRegister> table,
        Changed changed = [](std::uint32_t) {})
        : Registers{module_name}, table_{std::move(table)}, changed_{std::move(changed)} {}

private:
    TableRegister* at(std::uint32_t offset) {
        for (TableRegister& each : table_)
            if (each.offset == offset) return &each;
        return nullptr;
    }
    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time&) override {
        const TableRegister* found = at(offset);
        return found ? found->value : 0;
    }
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time&) override {
        TableRegister* found = at(offset);
        if (!found) return;
        const std::uint32_t kept = found->value & ~(value & found->clears);
        const std::uint32_t after = (kept & ~found->writable) | (value & found->writable);
        if (std::exchange(found->value, after) != after) changed_(offset);
    }

    std::vector<TableRegister> table_;
    Changed changed_;
};

}  // namespace sim
