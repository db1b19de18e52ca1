// main.cpp - collide-linux: the program on the board's Linux.
//
//   collide-linux                    the program, for ever
//   collide-linux --check            do board and program match?  Exit code 0 if so
//   collide-linux --self-test[=FILE] the checks of selftest/, and into FILE a report of them
//   collide-linux --table1           the paper's table, which needs no FPGA
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>

#include "app/app.h"
#include "bench/table1.h"
#include "board_memory.h"
#include "regmap.h"
#include "self_test_report.h"

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

constexpr const char* SELF_TEST_INTO = "--self-test=";

int check(linux_target::BoardMemory& io) {
    std::printf("system ID ok: 0x%08lX, register map 0x%08lX\n",
                static_cast<unsigned long>(io.read(regmap::SYSID_ID)),
                static_cast<unsigned long>(io.read(regmap::SYSID_HASH)));
    return 0;
}

int self_test(linux_target::BoardMemory& io, Processor& cpu, const char* file) {
    linux_target::SelfTestReport report;
    const unsigned failures = selftest::run(io, cpu, &report);
    if (file && !report.write(file, failures == 0)) {
        std::fprintf(stderr, "collide-linux: %s: cannot write: %s\n", file, std::strerror(errno));
        return 2;
    }
    return failures == 0 ? 0 : 1;
}

bool begins_with(const char* text, const char* word) {
    return std::strncmp(text, word, std::strlen(word)) == 0;
}

int usage(const char* got) {
    std::fprintf(stderr,
                 "collide-linux: expected nothing, --check, --self-test[=FILE] or --table1, "
                 "got \"%s\"\n",
                 got);
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    Processor cpu;
    const char* const word = argc > 1 ? argv[1] : "";
    if (argc > 2) return usage(argv[2]);
    if (std::strcmp(word, "--table1") == 0) {
        bench::table1(cpu);
        return 0;
    }
    const bool checks = std::strcmp(word, "--check") == 0;
    const bool tests_into = begins_with(word, SELF_TEST_INTO);
    const bool tests = tests_into || std::strcmp(word, "--self-test") == 0;
    if (*word && !checks && !tests) return usage(word);

    linux_target::BoardMemory io;
    const std::string problem = io.open();
    if (!problem.empty()) {
        std::fprintf(stderr, "collide-linux: %s\n", problem.c_str());
        return 1;
    }
    if (checks) return check(io);
    if (tests) return self_test(io, cpu, tests_into ? word + std::strlen(SELF_TEST_INTO) : nullptr);
    app::run(io, cpu);
    return 1;
}
