@ stores.S - stores to the HPS-to-FPGA bridge, for arm_stores_test.cpp
#include "program.inc"
    .text

    .equ BRIDGE, 0xC0000000         @ Normal memory that is not cached
    .equ BRIDGE_DEVICE, 0xC0100000  @ Device memory
    .equ TABLE, 0x00100000

@ A flat table: RAM and BRIDGE Normal, all else Device; the MMU on.
memory_on:
    ldr r0, =TABLE
    ldr r1, =0x00000C06             @ section, full access, Device
1:  str r1, [r0], #4
    adds r1, r1, #0x100000
    bcc 1b
    ldr r0, =TABLE
    ldr r1, =0x00001C0E             @ Normal, write-back
    str r1, [r0]
    ldr r1, =(BRIDGE | 0x1C02)      @ Normal, not cached
    add r2, r0, #(BRIDGE >> 18)
    str r1, [r2]
    mcr p15, 0, r0, c2, c0, 0       @ TTBR0
    mov r0, #1
    mcr p15, 0, r0, c3, c0, 0       @ DACR: client
    mrc p15, 0, r0, c1, c0, 0
    orr r0, r0, #1
    mcr p15, 0, r0, c1, c0, 0
    isb
    bx lr
    .ltorg

@ r1 words 1, 2, ... to r0 on.
fill:
    mov r2, #1
1:  str r2, [r0], #4
    add r2, r2, #1
    cmp r2, r1
    bls 1b
    bx lr

    .macro normal_program name
    program \name
    bl memory_on
    ldr r0, =BRIDGE
    .endm

    normal_program test_stores_in_a_row
    add r0, r0, #0x28
    mov r1, #30
    bl fill
    done

    normal_program test_stores_of_all_sizes
    ldr r1, =0x11223344
    str r1, [r0], #4                @ alone: the first in its page
    strb r1, [r0], #1
    strb r1, [r0], #1
    strh r1, [r0], #2
    floating_point_on
    vmov.i8 q0, #0x55
    vst1.32 {q0}, [r0]!
    stm r0!, {r1, r2}
    done

    normal_program test_stores_in_order
    ldr r1, =PROBE
    add r3, r0, #0x100
    str r0, [r0]
    str r0, [r0, #4]
    str r0, [r0, #8]
    str r0, [r3]                    @ not after it
    str r0, [r3, #4]
    str r1, [r1]                    @ Device
    str r0, [r0, #12]
    str r0, [r0, #16]
    ldr r2, [r0, #16]
    str r0, [r0, #20]
    done

    normal_program test_stores_to_a_device
    ldr r0, =BRIDGE_DEVICE
    mov r1, #4
    bl fill
    done

    normal_program test_stores_with_the_mmu_off
    mrc p15, 0, r1, c1, c0, 0
    bic r1, r1, #1
    mcr p15, 0, r1, c1, c0, 0
    isb
    mov r1, #4
    bl fill
    done

    normal_program test_stores_to_nobody
    add r0, r0, #0x7000
    add r0, r0, #0xFF0
    mov r1, #8                      @ four of them without a target
    bl fill
    done

    normal_program test_stores_and_computes
    str r0, [r0]
    str r0, [r0, #4]
    b .
