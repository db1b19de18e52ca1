// main.cpp - collide-linux: the program on the board's Linux.
//
// With --table1: the paper's table instead, which needs no FPGA.
#include <cstdio>
#include <cstring>
#include <ctime>

#include "app/app.h"
#include "bench/table1.h"
#include "board_memory.h"

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
    if (argc > 1) {
        std::fprintf(stderr, "collide-linux: expected nothing or --table1, got \"%s\"\n", argv[1]);
        return 2;
    }
    linux_target::BoardMemory io;
    const std::string problem = io.open();
    if (!problem.empty()) {
        std::fprintf(stderr, "collide-linux: %s\n", problem.c_str());
        return 1;
    }
    app::run(io, cpu);
    return 1;
}
