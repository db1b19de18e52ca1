// memory.h - where a program finds the FPGA's memories: the ARM behind its bridge, Nios V at once
#pragma once

#ifdef __riscv
enum { ONCHIP = 0x08000000, CHARACTERS = 0x09000000 };
enum { PICTURES = 0x02000000 };  // in the SDRAM, behind the program
#else
enum { ONCHIP = 0xC8000000, CHARACTERS = 0xC9000000 };
enum { PICTURES = 0xC0000000 };  // the SDRAM
#endif
