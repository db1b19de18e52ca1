// ps2_commands.c - sends commands to both PS/2 ports and awaits each answer by reading the port in
// a loop, with another period each time: as fast as it goes, up to 1 ms
//
// Ten commands for each that SW says, or 24.
#include "registers.h"

#define PS2(port) REGISTER(0xFF200100 + 8 * (port))
#define CE (1u << 10)
#define TIMER REGISTER(0xFFFEC200)  // 200 MHz
#define TIMER_CONTROL REGISTER(0xFFFEC208)
#define UART_THR REGISTER(0xFFC02000)

#define MS 200000u

static uint32_t chance = 1;

static uint32_t random_number(void) {
    chance ^= chance << 13;
    chance ^= chance >> 17;
    return chance ^= chance << 5;
}

static void spin(uint32_t turns) {
    while (turns--) __asm__ volatile("");
}

// The next byte, or -1.
static int byte_from(int port, uint32_t turns, uint32_t most) {
    const uint32_t begin = TIMER;
    for (;;) {
        const uint32_t data = PS2(port);
        if (data & 0x8000) return data & 0xFF;
        if (TIMER - begin > most) return -1;
        spin(turns);
    }
}

static void print(const char* text) {
    for (; *text; ++text) UART_THR = (uint32_t)*text;
}

static void print_number(uint32_t number) {
    char digits[11], *at = digits + 10;
    *at = 0;
    do *--at = (char)('0' + number % 10);
    while (number /= 10);
    print(at);
}

// A command, how many bytes are answered, and the first and the second of these.
struct Command {
    uint8_t byte, answers, first, second;
};
static const struct Command KEYBOARD[] = {
    {0xEE, 1, 0xEE, 0}, {0xF2, 3, 0xFA, 0xAB}, {0xF4, 1, 0xFA, 0}, {0xED, 1, 0xFA, 0},
    {0x02, 1, 0xFA, 0}, {0xAA, 1, 0xFE, 0},    {0xF6, 1, 0xFA, 0}};
static const struct Command MOUSE[] = {
    {0xF4, 1, 0xFA, 0}, {0xF2, 2, 0xFA, 0x00}, {0xE9, 4, 0xFA, 0x20}, {0xE8, 1, 0xFA, 0},
    {0x03, 1, 0xFA, 0}, {0xEB, 4, 0xFA, 0x08}, {0xF6, 1, 0xFA, 0}};
#define COMMANDS 7

static int is_answered(int port, const struct Command* command, uint32_t turns) {
    PS2(port) = command->byte;
    for (int n = 0; n < command->answers; ++n) {
        const int byte = byte_from(port, turns, 20 * MS);
        if (byte < 0 || (n == 0 && byte != command->first) || (n == 1 && byte != command->second))
            return 0;
    }
    return !(PS2(port) & 0x8000) && !(REGISTER(0xFF200104 + 8 * port) & CE);
}

int main(void) {
    const struct Command* commands[2];
    TIMER_CONTROL |= 1;
    for (int port = 0; port < 2; ++port) {  // AA of the test; a mouse's 00 after it
        byte_from(port, 100, 1000 * MS);
        commands[port] = byte_from(port, 100, 2 * MS) == 0 ? MOUSE : KEYBOARD;
    }
    const uint32_t count = SW_DATA ? 10 * SW_DATA : 24;
    uint32_t answered = 0;
    for (uint32_t n = 0; n < count; ++n) {
        const uint32_t octave = random_number() % 19;  // a turn takes two instructions
        const uint32_t turns = random_number() % (1u << octave);
        const int port = n & 1;
        answered += is_answered(port, &commands[port][n / 2 % COMMANDS], turns);
        spin(random_number() % 100000);
    }
    print("answered ");
    print_number(answered);
    print(" of ");
    print_number(count);
    print("\n");
    return 0;
}
