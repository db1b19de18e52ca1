// dev_mem_classes.cpp - Linux: a class maps the board's registers from /dev/mem, others use it.
//
// LEDs follow the switches; KEY0 counts up on HEX1-0; the A9's private timer, reached through the
// same mapping, walks a segment on HEX5 every 50 ms.  KEY3 ends the program.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>

namespace {

constexpr unsigned BASE = 0xFF200000, SPAN = 0xDEC700;
constexpr unsigned LEDR = 0x00, HEX3_0 = 0x20, HEX5_4 = 0x30, SW = 0x40, KEY_EDGE = 0x5C,
                   TIMER_LOAD = 0xDEC600, TIMER_CONTROL = 0xDEC608, TIMER_STATUS = 0xDEC60C;
constexpr unsigned STEP = 200'000'000 / 20;  // 50 ms at 200 MHz
constexpr unsigned ENABLE = 1, AUTO = 2;

class Board {
public:
    Board() : file_{open("/dev/mem", O_RDWR | O_SYNC)} {
        if (file_ < 0) {
            std::cerr << "cannot open /dev/mem\n";
            std::exit(1);
        }
        void* const map = mmap(nullptr, SPAN, PROT_READ | PROT_WRITE, MAP_SHARED, file_, BASE);
        if (map == MAP_FAILED) {
            std::cerr << "cannot map the registers\n";
            close(file_);
            std::exit(1);
        }
        base_ = static_cast<char*>(map);
    }
    ~Board() {
        munmap(base_, SPAN);
        close(file_);
    }
    Board(const Board&) = delete;
    Board& operator=(const Board&) = delete;

    void write(unsigned offset, unsigned value) { *at(offset) = value; }
    unsigned read(unsigned offset) const { return *at(offset); }

private:
    volatile unsigned* at(unsigned offset) const {
        return reinterpret_cast<volatile unsigned*>(base_ + offset);
    }

    int file_;
    char* base_ = nullptr;
};

class Display {
public:
    explicit Display(Board& board) : board_{board} {}

    void number(unsigned value) {
        static const unsigned char digits[] = {0x3F, 0x06, 0x5B, 0x4F, 0x66,
                                               0x6D, 0x7D, 0x07, 0x7F, 0x6F};
        board_.write(HEX3_0, digits[value % 10] | digits[value / 10 % 10] << 8);
    }
    void segment(unsigned which) { board_.write(HEX5_4, 1u << (which % 6 + 8)); }

private:
    Board& board_;
};

class Timer {
public:
    explicit Timer(Board& board) : board_{board} {
        board_.write(TIMER_LOAD, STEP);
        board_.write(TIMER_CONTROL, AUTO | ENABLE);
    }
    ~Timer() { board_.write(TIMER_CONTROL, 0); }

    bool expired() {
        if (!(board_.read(TIMER_STATUS) & 1)) return false;
        board_.write(TIMER_STATUS, 1);
        return true;
    }

private:
    Board& board_;
};

}  // namespace

int main() {
    Board board;
    Display display{board};
    Timer timer{board};
    unsigned count = 0, segment = 0;
    display.number(count);
    display.segment(segment);
    std::cout << "ready" << std::endl;
    for (;;) {
        board.write(LEDR, board.read(SW));
        const unsigned edges = board.read(KEY_EDGE);
        board.write(KEY_EDGE, edges);
        if (edges & 1) display.number(++count);
        if (edges & 8) break;
        if (timer.expired()) display.segment(++segment);
    }
    board.write(LEDR, 0);
    std::cout << "counted to " << count << std::endl;
}
