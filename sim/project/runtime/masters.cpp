#include "sim/project/runtime/masters.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <deque>
#include <string>
#include <utility>

#include "sim/project/runtime/endings.h"

#include "svdpi.h"

namespace sim::project {

namespace {

using Answer = ProcessorMemory::Answer;

constexpr std::uint64_t NEVER = ~std::uint64_t{0};
constexpr std::uint64_t LONGEST_PS = 20'000'000'000;  // 20 ms, as for the processor's accesses
constexpr unsigned FIXED = 0, WRAPS = 2;              // AXI's AxBURST
constexpr int OKAY = 0, SLVERR = 2, DECERR = 3;       // AXI's responses

// Addresses of its words: ARM IHI 0022D (AXI3), A3.4.1.
struct MasterBurst {
    std::uint32_t address;
    unsigned beats, left, bytes, kind, width;  // bytes: of a word; width: of the bus

    void next() {
        const std::uint32_t whole = beats * bytes, after = address / bytes * bytes + bytes;
        if (kind == WRAPS)
            address = address / whole * whole + after % whole;
        else if (kind != FIXED)
            address = after;
        --left;
    }
};

struct MasterWord {
    std::uint8_t lanes[32];
    int response;
};

struct MasterPort {
    std::deque<MasterBurst> writes;
    std::deque<MasterWord> read;
    std::uint64_t waits_since_ps = NEVER;  // for its turn
    bool is_reported = false;
};

ProcessorMemory* memory = nullptr;
std::array<MasterPort, ProcessorMemory::PORTS> ports;

// "ram.f2sdram (fpga2sdram, command port 0)": the primitive, or what stands for it, around the
// model that calls.
std::string name_of(unsigned port) {
    std::string name = svGetNameFromScope(svGetScope());
    const std::string design = "de1sim_design.";
    if (const auto begin = name.find(design); begin != std::string::npos)
        name.erase(0, begin + design.size());
    for (const char* part : {".reads", ".writes", ".port", ".command"})
        if (const auto at = name.rfind(part); at != std::string::npos) name.erase(at);
    if (port == ProcessorMemory::FPGA2HPS) return name + " (fpga2hps)";
    return name + " (fpga2sdram, command port " + std::to_string(port) + ")";
}

void report_once(unsigned port, const std::string& what) {
    if (std::exchange(ports[port].is_reported, true) || !evaluated.report) return;
    evaluated.report((name_of(port) + what).c_str());
}

int response(unsigned port, bool write, std::uint32_t address, Answer answer) {
    if (answer == Answer::DONE) return OKAY;
    char what[40];
    std::snprintf(what, sizeof what, ": %s 0x%08X, ", write ? "writes" : "reads", address);
    if (answer == Answer::NOBODY) {
        report_once(port, std::string{what} + "where nobody is; the answer is DECERR");
        return DECERR;
    }
    end_run(Ending::Kind::STOPPED,
            name_of(port) + what +
                "but the processor's DDR3 ends at 0x3FFFFFFF: expected a smaller address, or a "
                "shorter burst");
    return SLVERR;
}

MasterWord read_word(unsigned port, const MasterBurst& burst) {
    MasterWord word{};
    const std::uint32_t address = burst.address;
    const Answer answer = memory->access(port, false, address, word.lanes + address % burst.width,
                                         burst.bytes - address % burst.bytes, evaluated.time_ps);
    word.response = response(port, false, address, answer);
    return word;
}

}  // namespace

void set_processor_memory(ProcessorMemory* of_design) {
    memory = of_design;
    ports = {};
}

}  // namespace sim::project

using namespace sim::project;

extern "C" int de1sim_hps_takes(int number) {
    const auto port = static_cast<unsigned>(number);
    std::uint64_t& since_ps = ports[port].waits_since_ps;
    const std::uint64_t now_ps = evaluated.time_ps;
    if (memory && memory->takes(port, now_ps)) {
        since_ps = NEVER;
        return 1;
    }
    since_ps = std::min(since_ps, now_ps);
    if (!memory)
        report_once(port,
                    ": nothing is answered, since no program (--elf) has set up the processor's "
                    "memory");
    else if (now_ps - since_ps > LONGEST_PS && !memory->is_open(port))
        report_once(port, std::string{": nothing is answered for 20 ms, since the program holds it "
                                      "in reset ("} +
                              (port == ProcessorMemory::FPGA2HPS ? "brgmodrst, 0xFFD0501C)"
                                                                 : "fpgaportrst, 0xFFC25080)"));
    return 0;
}

extern "C" long long de1sim_hps_begin(int number, int write, int address, int beats, int size,
                                      int kind, int width) {
    const auto port = static_cast<unsigned>(number), words = static_cast<unsigned>(beats);
    const auto bus = static_cast<unsigned>(width);
    MasterBurst burst{static_cast<std::uint32_t>(address), words, words, std::min(1u << size, bus),
                      static_cast<unsigned>(kind),         bus};
    const std::uint64_t due_ps = memory->begin(words * burst.bytes, evaluated.time_ps);
    if (write) {
        ports[port].writes.push_back(burst);
    } else {
        for (; burst.left > 0; burst.next()) ports[port].read.push_back(read_word(port, burst));
    }
    return static_cast<long long>(due_ps);
}

extern "C" long long de1sim_hps_time() { return static_cast<long long>(evaluated.time_ps); }

extern "C" int de1sim_hps_read(int number, svBitVecVal* data) {
    std::deque<MasterWord>& read = ports[static_cast<unsigned>(number)].read;
    if (read.empty()) return SLVERR;  // of a burst of no words
    const MasterWord word = read.front();
    read.pop_front();
    std::memcpy(data, word.lanes, sizeof word.lanes);
    return word.response;
}

extern "C" int de1sim_hps_write(int number, int enabled, const svBitVecVal* data) {
    const auto port = static_cast<unsigned>(number), strobes = static_cast<unsigned>(enabled);
    std::deque<MasterBurst>& writes = ports[port].writes;
    MasterBurst& burst = writes.front();
    const std::uint32_t base = burst.address / burst.width * burst.width;
    MasterWord word{};
    std::memcpy(word.lanes, data, sizeof word.lanes);
    Answer worst = Answer::DONE;
    const auto is_enabled = [&](unsigned n) { return n < burst.width && strobes >> n & 1; };
    for (unsigned n = 0; n < burst.width; ++n) {
        const unsigned first = n;
        while (is_enabled(n)) ++n;
        if (n > first)
            worst = std::max(worst, memory->access(port, true, base + first, word.lanes + first,
                                                   n - first, evaluated.time_ps));
    }
    burst.next();
    if (burst.left == 0 || burst.beats == 0) writes.pop_front();
    return response(port, true, base, worst);
}
