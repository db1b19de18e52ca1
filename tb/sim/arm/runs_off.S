@ runs_off.S - programs that leave their code, for arm_failure_test.cpp
#include "program.inc"
    .text

    .equ ZEROS, 0x00300000

    program test_runs_off
    bl outer
    done

    program outer
    push {r4, lr}
    bl inner
    pop {r4, pc}

    program inner
    sub sp, sp, #16
    push {lr}
    ldr r0, =ZEROS
    blx r0
    pop {pc}
    .ltorg

    program test_runs_off_in_thumb
    bl thumb_outer
    done

    .thumb
    program thumb_outer
    push {r4, lr}
    ldr r1, =thumb_inner
    blx r1
    pop {r4, pc}

    program thumb_inner
    push {lr}
    ldr r0, =(ZEROS + 1)
    blx r0
    pop {pc}
    .ltorg
