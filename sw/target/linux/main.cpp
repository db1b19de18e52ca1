// main.cpp - collide-linux: the program on the board's Linux.
//
// With --table1: the paper's table instead, which needs no FPGA.
// With --check: do board and program go together?  Prints "system ID ok: ..." and exits 0, or what
// is wrong and exits 1.
#include <cstdio>
#include <cstring>
#include <ctime>

#include "app/app.h"
#include "bench/table1.h"
#include "board_memory.h"
#include "regmap.h"

namespace {

class Processor : public hal::Cpu {
public:
    void idle() override {
        const timespec fifty_us{0, 50'000};
        nanosleep(&fifty_us, nullptr);
    }
    std::uint32_t micros() override {
        timespec now{};
        clock_gettime(CLOCK_MONOTONIC, &now);
        return static_cast<std::uint32_t>(static_cast<std::uint64_t>(now.tv_sec) * 1'000'000 +
                                          static_cast<std::uint64_t>(now.tv_nsec) / 1000);
    }
    void print(const char* text) override {
        std::fputs(text, stdout);
        std::fflush(stdout);
    }
};

}  // namespace

int main(int argc, char** argv) {
    Processor cpu;
    if (argc == 2 && std::strcmp(argv[1], "--table1") == 0) {
        bench::table1(cpu);
        return 0;
    }
    const bool check = argc == 2 && std::strcmp(argv[1], "--check") == 0;
    if (argc > 1 && !check) {
        std::fprintf(stderr, "collide-linux: expected nothing, --check or --table1, got \"%s\"\n",
                     argv[1]);
        return 2;
    }
    linux_target::BoardMemory io;
    const std::string problem = io.open();
    if (!problem.empty()) {
        std::fprintf(stderr, "collide-linux: %s\n", problem.c_str());
        return 1;
    }
    if (check) {
        std::printf("system ID ok: 0x%08lX, register map 0x%08lX\n",
                    static_cast<unsigned long>(io.read(regmap::SYSID_ID)),
                    static_cast<unsigned long>(io.read(regmap::SYSID_HASH)));
        return 0;
    }
    app::run(io, cpu);
    return 1;
}
