@ astray.S - programs whose pc or stack goes where it cannot belong, for arm_astray_test.cpp
#include "program.inc"
    .text

    .equ ON_CHIP_RAM, 0xFFFF0000
    .equ MORE_RAM, 0xD0000000
    .equ PAUSE, 200000                  @ instructions, of more than a quantum

    .macro pause
    ldr r0, =PAUSE
1:  subs r0, r0, #1
    bne 1b
    .endm

    program test_goes_into_data
    ldr r0, =table
    blx r0
    done

    program test_returns_from_its_data
    ldr r0, =harmless
    blx r0
    done

    program test_comes_to_a_wrong_instruction_in_data
    ldr r0, =wrong
    blx r0
    done

    .macro handled_by handler           @ aborts go to it
    ldr r0, =9f
    mcr p15, 0, r0, c12, c0, 0
    b 8f
    .balign 32
9:  .rept 8
    b \handler
    .endr
8:
    .endm

    program test_goes_back_to_its_abort
    handled_by 2f
    ldr r2, =NOBODY
    ldr r3, [r2]
    done
2:  subs pc, lr, #8

@ The stack of a recursion that has no end, which begins at r4.
    program recursion
    mov sp, r4
    pause
1:  push {r0, lr}
    mov r0, #1000
2:  subs r0, r0, #1
    bne 2b
    b 1b
    .ltorg

    program test_stack_below_on_chip_ram
    ldr r4, =ON_CHIP_RAM + 0x400
    b recursion
    .ltorg

@ Below there is no target.
    program test_stack_below_more_ram
    handled_by 2f
    ldr sp, =MORE_RAM + 8
    pause
    push {r0, r1}
    push {r0, r1}
2:  b .
    .ltorg

    program test_stack_into_code
    ldr r4, =etext + 0x1000
    b recursion
    .ltorg

@ Twice other code at the same place, in the data and on the stack.
    .macro run_written place
    ldr r6, =0xE3A00005                 @ mov r0, #5
    ldr r7, =0xE12FFF1E                 @ bx lr
    stm \place, {r6, r7}
    blx \place
    mov r4, r0
    add r6, r6, #1
    str r6, [\place]
    blx \place
    mov r5, r0
    .endm

    program test_runs_what_it_has_written_into_its_data
    ldr r8, =stack_in_data
    run_written r8
    done

    program test_runs_what_it_has_written_onto_its_stack
    sub sp, sp, #16
    run_written sp
    done

@ As programs set them: at the end of the code, in the data, from one to the other.
    program test_stacks_that_are_in_their_place
    ldr sp, =etext
    pause
    push {r0-r12}
    pause
    pop {r0-r12}
    ldr sp, =stack_in_text
    push {r0-r12}
    pause
    ldr sp, =stack_in_data
    push {r0-r12}
    pause
    cps #0x12
    ldr sp, =0xFFFFFFFC
    push {r0-r12}
    pause
    cps #0x13
    pause
    done

    .space 128
stack_in_text:
    .ltorg

    .data
    .balign 4
table:
    b .
wrong:
    udf #3
harmless:
    add r1, r1, #1
    bx lr
    .space 128
stack_in_data:
