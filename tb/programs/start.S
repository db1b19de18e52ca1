@ start.S - bare start-up of a test program: vectors at 0, a stack, main, then sleep
    .syntax unified
    .arch armv7-a
    .arm

    .section .vectors, "ax"
    .global _start
_start:
    b reset
    b .                             @ undefined
    b .                             @ SVC
    b .                             @ prefetch abort
    b on_data_abort
    nop
    b on_irq
    b .                             @ FIQ

    .text
    .type reset, %function
reset:
    cps #0x12                       @ IRQ mode
    ldr sp, =0x03100000
    cps #0x13                       @ SVC mode
    ldr sp, =0x03000000
    bl main
1:  wfi
    b 1b

    .type on_data_abort, %function
on_data_abort:                      @ skips the access
    subs pc, lr, #4
    .size on_data_abort, . - on_data_abort

    .weak on_irq                    @ the program's own, if it has one
    .type on_irq, %function
on_irq:
    b .
