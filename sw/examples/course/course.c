// course.c - a program as courses have it: KEY0 moves a box on the monitor, by an interrupt
//
// Addresses as numbers, two pixel buffers in arrays that take turns, printf; on the ARM a handler by
// the name that Intel's Monitor Program gives it, on Nios V one whose address the program writes.
#include <math.h>
#include <stdio.h>

#define SIZE 40

short int Buffer1[240][512];  // a row is 512 pixels long, 320 of them are shown
short int Buffer2[240][512];
int pixel_buffer_start;

volatile int moves = 0;  // volatile: changed by the handler, read by main()

#ifdef __riscv  // Nios V

void __attribute__((interrupt("machine"))) handler(void) {
    int cause;
    __asm__ volatile("csrr %0, mcause" : "=r"(cause));
    if (cause == (int)0x80000012) {  // interrupt 18: the keys
        volatile int* key_ptr = (int*)0xFF200050;
        key_ptr[3] = key_ptr[3];  // edge capture: a 1 clears its bit
        moves++;
    }
}

void set_up_interrupts(void) {
    *(volatile int*)0xFF200058 = 1;  // KEY0 may interrupt
    __asm__ volatile("csrw mtvec, %0" ::"r"(&handler));
    __asm__ volatile("csrs mie, %0" ::"r"(1 << 18));
    __asm__ volatile("csrsi mstatus, 8");
}

#else  // the ARM

void __attribute__((interrupt)) __cs3_isr_irq(void) {
    int id = *(volatile int*)0xFFFEC10C;  // ICCIAR
    if (id == 73) {                       // the keys
        volatile int* key_ptr = (int*)0xFF200050;
        key_ptr[3] = key_ptr[3];  // edge capture: a 1 clears its bit
        moves++;
    }
    *(volatile int*)0xFFFEC110 = id;  // ICCEOIR
}

void set_up_interrupts(void) {
    *(volatile int*)0xFF200058 = 1;          // KEY0 may interrupt
    *(volatile char*)(0xFFFED800 + 73) = 1;  // ICDIPTR: interrupt 73 goes to this processor
    *(volatile int*)0xFFFED108 = 1 << 9;     // ICDISER: 73 = 2 * 32 + 9
    *(volatile int*)0xFFFEC104 = 0xFFFF;     // ICCPMR: all priorities
    *(volatile int*)0xFFFEC100 = 1;          // ICCICR
    *(volatile int*)0xFFFED000 = 1;          // ICDDCR
    __asm__ volatile("msr cpsr_c, #0x53");   // SVC mode, IRQ on
}

#endif

void plot_pixel(int x, int y, short int colour) {
    *(volatile short int*)(pixel_buffer_start + (y << 10) + (x << 1)) = colour;
}

void draw(int box_x, int box_y) {
    for (int y = 0; y < 240; y++)
        for (int x = 0; x < 320; x++) {
            int inside = x >= box_x && x < box_x + SIZE && y >= box_y && y < box_y + SIZE;
            plot_pixel(x, y, inside ? 0xFFE0 : 0x0010);
        }
}

void wait_for_vsync(void) {
    volatile int* pixel_ctrl_ptr = (int*)0xFF203020;
    *pixel_ctrl_ptr = 1;  // the buffers change over at the end of the frame
    while (pixel_ctrl_ptr[3] & 1)
        ;
}

int main(void) {
    volatile int* pixel_ctrl_ptr = (int*)0xFF203020;
    volatile int* LEDR_ptr = (int*)0xFF200000;
    int printed = 0;

    pixel_ctrl_ptr[1] = (int)&Buffer1;
    wait_for_vsync();
    pixel_ctrl_ptr[1] = (int)&Buffer2;
    pixel_buffer_start = pixel_ctrl_ptr[1];

    set_up_interrupts();
    printf("KEY0 moves the box\n");
    while (1) {
        int now = moves;
        int x = now * 40 % 280, y = now * 30 % 200;
        *LEDR_ptr = now;
        if (printed != now) {
            printed = now;
            printf("box at %d, %d: %.3f from the corner\n", x, y, sqrt(x * x + y * y));
        }
        draw(x, y);
        wait_for_vsync();
        pixel_buffer_start = pixel_ctrl_ptr[1];
    }
}
