// qemu_shared.h - what qemu.cpp and its guest, qemu_guest.c, exchange through a file
//
// The guest is a program for ARM Linux that qemu-arm runs.  It stops at an undefined instruction or
// another signal, writes its registers into the file, says so by a byte on standard output, and
// goes on with the registers that are there when a byte comes on standard input.
#pragma once

#include <stdint.h>

#define QEMU_CODE 0x10000
#define QEMU_DATA 0x40000000u
#define QEMU_FAR_DATA 0xC0000000u
#define QEMU_PART 0x10000
#define QEMU_PARTS 10

struct QemuShared {
    uint32_t r[16];  // up to pc
    uint32_t cpsr, fpscr;
    uint64_t d[32];
    uint32_t signal;                        // from the guest: its signal
    uint32_t changed_begin, changed_bytes;  // to the guest: of the code, since the last time
    uint8_t unused[4096 - 4 * 18 - 8 * 32 - 4 * 3];
    uint8_t code[QEMU_PART], data[QEMU_PART];
};
