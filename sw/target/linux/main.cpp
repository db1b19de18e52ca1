// main.cpp - collide-linux: the program on the board's Linux.
#include <cstdio>
#include <ctime>

#include "app/app.h"
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

int main() {
    linux_target::BoardMemory io;
    const std::string problem = io.open();
    if (!problem.empty()) {
        std::fprintf(stderr, "collide-linux: %s\n", problem.c_str());
        return 1;
    }
    Processor cpu;
    app::run(io, cpu);
    return 1;
}
