// in_sdram.c - code, stack, heap and both pictures in the FPGA's SDRAM
//
// The pictures are global arrays.  A list is built on the heap, sorted and summed; the sum is drawn
// as a bar.  HEX shows the number of pictures that have been shown.
#include "processor.h"
#include "registers.h"

enum { WIDTH = 320, HEIGHT = 240, NUMBERS = 300 };

__attribute__((naked, section(".text._start"))) void _start(void) {
    __asm__("ldr sp, =0xC3FFFFF8 \n bl main \n b .");
}

static uint16_t pictures[2][HEIGHT][512];

struct Node {
    uint32_t value;
    struct Node* next;
};

extern uint8_t heap[];
static uint8_t* free_memory = heap;

static struct Node* insert(struct Node* first, uint32_t value) {
    struct Node* node = (struct Node*)free_memory;
    free_memory += sizeof *node;
    node->value = value;
    struct Node** at = &first;
    while (*at && (*at)->value < value) at = &(*at)->next;
    node->next = *at;
    *at = node;
    return first;
}

// Recursive, NUMBERS deep on the stack.  0 if the list is not sorted.
static uint32_t sum(const struct Node* node) {
    if (!node) return 0;
    if (node->next && node->next->value < node->value) return 0;
    return node->value + sum(node->next);
}

static void draw(uint16_t (*picture)[512], uint32_t bar) {
    for (uint32_t y = 0; y < HEIGHT; ++y)
        for (uint32_t x = 0; x < WIDTH; ++x)
            picture[y][x] = (uint16_t)(y < 16 && x < bar ? 0xFFFF : x / 10 << 11 | y / 4 << 5);
}

int main(void) {
    struct Node* list = 0;
    uint32_t value = 1;
    for (int i = 0; i < NUMBERS; ++i) {
        value = (value * 75 + 74) % 65537;  // the ZX81's
        list = insert(list, value);
    }
    const uint32_t bar = sum(list) % WIDTH;
    for (uint32_t shown = 0; shown < 2; ++shown) {
        uint16_t(*const picture)[512] = pictures[shown];
        draw(picture, bar + shown);
        PIXEL_BACK_BUFFER = (uint32_t)picture;
        PIXEL_BUFFER = 1;
        while (PIXEL_STATUS & 1) {
        }
        HEX3_0_DATA = DIGITS[shown + 1];
    }
    return 0;
}
