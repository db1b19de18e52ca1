@ vectors.S - the vectors, and handlers that note what they see in `record`
#include "program.inc"

    .section .vectors, "ax"
    .global vectors, on_svc
vectors:
    b .
    b on_undefined
    b on_svc
    b on_prefetch_abort
    b on_data_abort
    nop
    b on_irq
    b on_fiq

    .section .shared, "awx", %progbits   @ x: so that these names count as functions
    .global record, result
    .balign 8
record: .space 32
result: .space 64

    .text
    .macro save kind
    ldr r12, =record
    mov r10, #\kind
    str r10, [r12]
    str lr, [r12, #4]
    mrs r10, spsr
    str r10, [r12, #8]
    mrs r10, cpsr
    str r10, [r12, #20]
    .endm

on_undefined:
    save 1
    movs pc, lr
on_svc:
    save 2
    movs pc, lr
on_prefetch_abort:
    save 3
    mrc p15, 0, r10, c5, c0, 1
    str r10, [r12, #12]
    mrc p15, 0, r10, c6, c0, 2
    str r10, [r12, #16]
    movs pc, r11                    @ where the program wants to go on
on_data_abort:
    save 4
    mrc p15, 0, r10, c5, c0, 0
    str r10, [r12, #12]
    mrc p15, 0, r10, c6, c0, 0
    str r10, [r12, #16]
    subs pc, lr, #4                 @ after the instruction of an ARM program
on_irq:
    ldr r10, =PROBE
    str r10, [r10]                  @ as early as can be, for its time
    save 6
    ldr r10, =GIC_CPU
    ldr r12, [r10, #0x0C]
    str r12, [r10, #0x10]
    ldr r10, =result
    str r12, [r10]                  @ the ID
    ldr r10, =PRIVATE_TIMER
    mov r12, #1
    str r12, [r10, #0x0C]
    subs pc, lr, #4
on_fiq:
    save 7
    ldr r10, =GIC_CPU
    ldr r12, [r10, #0x0C]
    str r12, [r10, #0x10]
    subs pc, lr, #4
