@ interrupts.S - interrupts and sleep, for arm_interrupts_test.cpp
#include "program.inc"
    .text

    .macro enable_gic control
    ldr r0, =GIC_CPU
    mov r1, #0xF0
    str r1, [r0, #4]
    mov r1, #\control
    str r1, [r0]
    ldr r0, =GIC
    mov r1, #1
    str r1, [r0]
    mov r1, #(1 << 29)
    str r1, [r0, #0x100]
    .endm
    .macro stacks
    cps #0x12
    ldr sp, =0x10000
    cps #0x11
    ldr sp, =0x11000
    cps #0x13
    .endm
    .macro start_timer ticks
    ldr r0, =PRIVATE_TIMER
    ldr r1, =\ticks
    str r1, [r0]
    mov r1, #5
    str r1, [r0, #8]
    .endm

    program test_irq
    stacks
    enable_gic 1
    cpsie i
    ldr r0, =GIC
    ldr r1, =0x02000003             @ to itself, ID 3
    str r1, [r0, #0xF00]
    .global after_irq
after_irq:
    nop
    ldr r0, =result
    mov r1, #99
    str r1, [r0, #4]
    done

    program test_fiq
    stacks
    enable_gic 9
    cpsie f
    ldr r0, =GIC
    ldr r1, =0x02000003
    str r1, [r0, #0xF00]
    nop
    done

    program test_irq_when_let_in
    stacks
    enable_gic 1
    ldr r0, =GIC
    ldr r1, =0x02000003
    str r1, [r0, #0xF00]
    ldr r2, =result
    mov r4, #0
1:  add r4, r4, #1
    cmp r4, #1000
    bne 1b
    ldr r5, [r2]
    str r5, [r2, #8]                @ still 0: masked
    cpsie i
    mov r4, #0
2:  add r4, r4, #1
    ldr r5, [r2]
    cmp r5, #0
    beq 2b
    str r4, [r2, #4]
    done

    program test_wfi
    stacks
    enable_gic 1
    cpsie i
    start_timer 200000              @ 1 ms
    wfi
    ldr r0, =PROBE
    str r0, [r0, #4]
    done

    program test_busy_irq
    stacks
    enable_gic 1
    cpsie i
    start_timer 200000              @ 1 ms
1:  b 1b

    program test_wfi_masked
    stacks
    enable_gic 1
    start_timer 200000
    wfi
    ldr r0, =PROBE
    str r0, [r0, #4]
    b .

    program test_wfe
    sev
    wfe
    ldr r0, =result
    mov r1, #99
    str r1, [r0]
    done
