// dev_mem.cpp - registers as the courses' C++ classes reach them: LEDs, switches, the A9's timer
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace {

constexpr unsigned LW_BASE = 0xFF200000, SHORT_SPAN = 0x5000, LONG_SPAN = 0xDEC700;
constexpr unsigned LEDR = 0, SW = 0x40, TIMER = 0xDEC600;

class Board {
public:
    explicit Board(std::size_t span) : span_{span} {
        memory_ = open("/dev/mem", O_RDWR | O_SYNC);
        base_ = static_cast<char*>(
            mmap(nullptr, span, PROT_READ | PROT_WRITE, MAP_SHARED, memory_, LW_BASE));
    }
    ~Board() {
        munmap(base_, span_);
        close(memory_);
    }
    volatile unsigned& at(unsigned offset) {
        return *reinterpret_cast<volatile unsigned*>(base_ + offset);
    }

private:
    std::size_t span_;
    int memory_;
    char* base_;
};

}  // namespace

int main() {
    {
        Board board{SHORT_SPAN};
        board.at(LEDR) = 0x155;
        std::printf("leds read back %03x\n", board.at(LEDR));
    }
    Board board{LONG_SPAN};
    board.at(TIMER) = 200'000'000 / 1000 * 5 - 1;  // 5 ms at 200 MHz
    board.at(TIMER + 8) = 1;
    while ((board.at(TIMER + 12) & 1) == 0) {
    }
    board.at(TIMER + 12) = 1;
    std::printf("timer expired, status %u\n", board.at(TIMER + 12));

    const int memory = open("/dev/mem", O_RDWR | O_SYNC);
    const void* odd = mmap(nullptr, 16, PROT_READ, MAP_SHARED, memory, LW_BASE + 0x40);
    std::printf("an odd offset: %s\n", odd == MAP_FAILED ? std::strerror(errno) : "mapped");
    for (;;) board.at(LEDR) = board.at(SW);
}
