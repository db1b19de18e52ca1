@ key_interrupt.S - each KEY toggles the digit 0 - 3 on its own place of HEX3-0, by interrupt.
@ Vectors at 0, stack of IRQ mode at the last word of the on-chip RAM.
    .syntax unified
    .arm

    .equ KEYS, 73                   @ interrupt ID

    .section .vectors, "ax"
    .global _start
_start:
    b reset
    b .
    b .
    b .
    b .
    nop
    b on_irq
    b .

    .text
reset:
    msr cpsr_c, #0xD2
    ldr sp, =0xFFFFFFFF - 3
    msr cpsr_c, #0xD3
    ldr sp, =0x3FFFFFFF - 3

    ldr r0, =0xFFFED800 + KEYS      @ ICDIPTR, a byte an ID
    mov r1, #1
    strb r1, [r0]
    ldr r0, =0xFFFED100 + (KEYS / 32) * 4
    mov r1, #1 << (KEYS % 32)
    str r1, [r0]
    ldr r0, =0xFFFEC100
    ldr r1, =0xFFFF
    str r1, [r0, #4]                @ ICCPMR: let all priorities through
    mov r1, #1
    str r1, [r0]                    @ ICCICR
    ldr r0, =0xFFFED000
    str r1, [r0]                    @ ICDDCR
    ldr r0, =0xFF200050
    mov r1, #0xF
    str r1, [r0, #8]                @ all four may interrupt
    msr cpsr_c, #0x53               @ SVC mode, IRQ on
idle:
    b idle

    .type on_irq, %function
on_irq:
    push {r0-r5, lr}
    ldr r4, =0xFFFEC100
    ldr r5, [r4, #0xC]              @ ICCIAR
    cmp r5, #KEYS
unexpected:
    bne unexpected
    bl on_keys
    str r5, [r4, #0x10]             @ ICCEOIR
    pop {r0-r5, lr}
    subs pc, lr, #4

    .type on_keys, %function
on_keys:
    push {r4-r6, lr}
    ldr r0, =0xFF200050
    ldr r1, [r0, #0xC]
    str r1, [r0, #0xC]              @ a 1 clears its bit
    ldr r2, =0xFF200020
    ldr r3, [r2]
    ldr r4, =digits
    mov r6, #1
1:  ldrb r5, [r4], #1
    tst r1, r6
    eorne r3, r3, r5
    ror r3, r3, #8                  @ the next place; after four of them all stand as before
    lsl r6, r6, #1
    cmp r6, #0x10
    bne 1b
    str r3, [r2]
    pop {r4-r6, pc}

digits: .byte 0x3F, 0x06, 0x5B, 0x4F
    .ltorg
