// Bytes of GDB's protocol: as they come, or, after a byte of 1, lines that become packets.
#include <cstring>
#include <vector>

#include "sim/debug/arm_registers.h"
#include "sim/debug/gdb_commands.h"
#include "sim/debug/gdb_packet.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

namespace {

class Target final : public sim::GdbTarget {
public:
    const sim::GdbRegisters& registers() const override { return sim::arm_registers(); }
    std::uint64_t reg(unsigned number) override {
        must(number < sim::arm_register::COUNT, "a register that is read exists");
        return registers_[number];
    }
    bool set_reg(unsigned number, std::uint64_t value) override {
        must(number < sim::arm_register::COUNT, "a register that is written exists");
        registers_[number] = value;
        ++changes;
        return true;
    }
    std::size_t read(std::uint32_t address, void* data, std::size_t bytes) override {
        if (address >= memory_.size() || bytes == 0) return 0;
        bytes = std::min(bytes, memory_.size() - address);
        std::memcpy(data, memory_.data() + address, bytes);
        return bytes;
    }
    std::size_t write(std::uint32_t address, const void* data, std::size_t bytes) override {
        if (address >= memory_.size() || bytes > memory_.size() - address) return 0;
        if (bytes == 0) return 0;
        std::memcpy(memory_.data() + address, data, bytes);
        ++changes;
        return bytes;
    }
    void insert(const sim::GdbPoint&) override { ++changes; }
    void remove(const sim::GdbPoint&) override { ++changes; }
    std::string stop_reply() override { return "T05"; }
    std::string monitor(std::string_view) override { return "no such command\n"; }

    unsigned changes = 0;

private:
    std::uint64_t registers_[sim::arm_register::COUNT] = {};
    std::vector<char> memory_ = std::vector<char>(0x400, 'm');
};

// What the reader finds in the packet of `text`.
std::string sent(const std::string& text) {
    sim::GdbPacketReader reader;
    std::optional<sim::GdbEvent> event;
    for (const char byte : sim::gdb_packet(text)) {
        must(!event, "a packet ends with its last byte");
        event = reader.feed(byte);
    }
    must(event == sim::GdbEvent::PACKET || text.size() > sim::GDB_PACKET_BYTES,
         "a packet that is written is read");
    return reader.text();
}

void answer(Target& target, const std::string& packet) {
    const unsigned changes = target.changes;
    const sim::GdbAnswer answer = sim::gdb_answer(target, packet);
    must(answer.text.size() <= sim::GDB_PACKET_BYTES, "an answer fits into a packet");
    must(sent(answer.text) == answer.text, "an answer arrives as it was sent");
    must(answer.text != "E01" || target.changes == changes, "an error changes nothing");
}

}  // namespace

void try_gdb(std::string_view input) {
    Target target;
    if (!input.empty() && input[0] == 1) {
        input.remove_prefix(1);
        while (!input.empty()) {
            const std::string line{next_line(input)};
            if (line.size() > sim::GDB_PACKET_BYTES) continue;
            must(sent(line) == line, "a text arrives as it was sent");
            answer(target, line);
        }
        return;
    }
    sim::GdbPacketReader reader;
    for (const char byte : input)
        if (reader.feed(byte) == sim::GdbEvent::PACKET) answer(target, reader.text());
}

}  // namespace fuzz
