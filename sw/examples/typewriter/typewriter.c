// typewriter.c - what is typed on the keyboard appears on the monitor, by the keyboard's interrupt
//
// The handler takes the bytes out of the PS/2 port and keeps them; main() makes characters of them.
// So no byte is lost while main() writes, and the processor sleeps while nobody types.  HEX1-0 counts
// the bytes.
#include "processor.h"
#include "screen.h"

enum { BREAK = 0xF0, LEFT_SHIFT = 0x12, RIGHT_SHIFT = 0x59, ENTER = 0x5A, BACKSPACE = 0x66 };
enum { KEPT = 64, LEFT = 4, RIGHT = 76, TOP = 4 };

static volatile uint8_t bytes[KEPT];
static volatile unsigned came;  // how many; the last KEPT of them are in `bytes`

INTERRUPT_HANDLER on_irq(void) {
    const uint32_t id = interrupt_begin();
    if (id == PS2_INTERRUPT)
        for (uint32_t data; (data = PS2_0_DATA) & 0x8000;) {  // RVALID: a byte was there
            bytes[came % KEPT] = (uint8_t)data;
            ++came;
        }
    interrupt_end(id);
}

// Of the key with this code, 0: none.
static char character(uint8_t code, int shift) {
    static const struct {
        uint8_t code;
        char plain, shifted;
    } KEYS[] = {
        {0x1C, 'a', 'A'}, {0x32, 'b', 'B'}, {0x21, 'c', 'C'}, {0x23, 'd', 'D'}, {0x24, 'e', 'E'},
        {0x2B, 'f', 'F'}, {0x34, 'g', 'G'}, {0x33, 'h', 'H'}, {0x43, 'i', 'I'}, {0x3B, 'j', 'J'},
        {0x42, 'k', 'K'}, {0x4B, 'l', 'L'}, {0x3A, 'm', 'M'}, {0x31, 'n', 'N'}, {0x44, 'o', 'O'},
        {0x4D, 'p', 'P'}, {0x15, 'q', 'Q'}, {0x2D, 'r', 'R'}, {0x1B, 's', 'S'}, {0x2C, 't', 'T'},
        {0x3C, 'u', 'U'}, {0x2A, 'v', 'V'}, {0x1D, 'w', 'W'}, {0x22, 'x', 'X'}, {0x35, 'y', 'Y'},
        {0x1A, 'z', 'Z'}, {0x45, '0', ')'}, {0x16, '1', '!'}, {0x1E, '2', '@'}, {0x26, '3', '#'},
        {0x25, '4', '$'}, {0x2E, '5', '%'}, {0x36, '6', '^'}, {0x3D, '7', '&'}, {0x3E, '8', '*'},
        {0x46, '9', '('}, {0x29, ' ', ' '}, {0x41, ',', '<'}, {0x49, '.', '>'}};
    for (unsigned i = 0; i < sizeof KEYS / sizeof KEYS[0]; ++i)
        if (KEYS[i].code == code) return shift ? KEYS[i].shifted : KEYS[i].plain;
    return 0;
}

static int column = LEFT, line = TOP;

static void put(char c) {
    const char text[2] = {c, 0};
    screen_text(column, line, text);
}

static void new_line(void) {
    put(' ');  // where the cursor was
    column = LEFT;
    line = line == LINES - TOP ? TOP : line + 1;
}

static void pressed(uint8_t code, int shift) {
    const char c = character(code, shift);
    if (c) {
        put(c);
        if (++column == RIGHT) new_line();
    } else if (code == ENTER) {
        new_line();
    } else if (code == BACKSPACE && column > LEFT) {
        put(' ');
        --column;
    }
    put('_');
}

// Until there is another byte than these.  WFI ends by an interrupt that is disabled, too, so one that
// comes between the comparison and WFI is not missed.
static void sleep_after(unsigned taken) {
    interrupts_disable();
    while (taken == came) {
        __asm volatile("wfi");
        interrupts_enable();  // the handler runs
        interrupts_disable();
    }
    interrupts_enable();
}

int main(void) {
    int released = 0, shift = 0;
    screen_begin();
    put('_');
    PS2_0_CONTROL = 1;  // RE: a byte interrupts
    interrupt_on(PS2_INTERRUPT);
    interrupts_enable();
    for (unsigned taken = 0;;) {
        sleep_after(taken);
        const uint8_t code = bytes[taken++ % KEPT];
        HEX3_0_DATA = (uint32_t)DIGITS[taken / 10 % 10] << 8 | DIGITS[taken % 10];
        if (code == BREAK) {
            released = 1;
            continue;
        }
        if (code == LEFT_SHIFT || code == RIGHT_SHIFT)
            shift = !released;
        else if (!released)
            pressed(code, shift);
        released = 0;
    }
}
