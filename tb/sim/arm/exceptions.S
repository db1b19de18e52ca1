@ exceptions.S - reset, aborts and other exceptions, for arm_exceptions_test.cpp
#include "program.inc"
    .text

    program test_undefined
    udf #1
    ldr r0, =result
    mov r1, #99
    str r1, [r0]
    done

    program test_svc
    svc #5
    ldr r0, =result
    mov r1, #99
    str r1, [r0]
    done

    program test_read_abort
    ldr r1, =NOBODY
    mov r2, #42
    mov r3, r1
    .global at_read_abort
at_read_abort:
    ldr r2, [r3, #4]!
    ldr r0, =result
    stm r0, {r2, r3}
    done

    program test_write_abort
    ldr r3, =NOBODY
    .global at_write_abort
at_write_abort:
    strb r3, [r3, #7]
    ldr r0, =result
    mov r1, #99
    str r1, [r0]
    done

    program test_ldm_abort
    ldr r3, =NOBODY
    mov r4, #4
    .global at_ldm_abort
at_ldm_abort:
    ldmia r3!, {r4, r5}
    ldr r0, =result
    stm r0, {r3, r4}
    done

    program test_prefetch_abort
    ldr r11, =1f
    ldr r1, =NOBODY
    bx r1
1:  ldr r0, =result
    mov r1, #99
    str r1, [r0]
    done

    program test_half_prefetch_abort
    ldr r11, =1f
    ldr r1, =0x3FFFFFFE             @ the end of DDR3
    ldr r2, =0xF100                 @ the first half of add.w
    strh r2, [r1]
    add r1, r1, #1
    bx r1
    .thumb
1:  cpsid if
    wfi
    b .
    .ltorg
    .arm

    program test_bkpt
    ldr r11, =1f
    .global at_bkpt
at_bkpt:
    bkpt #3
1:  done

    program test_no_vector
    ldr r0, =0x200000
    mcr p15, 0, r0, c12, c0, 0
    svc #0
    done

    program test_semihosting
    mov r0, #42
    svc #0x123456
    ldr r1, =result
    str r0, [r1]
    done

    program test_semihosting_in_thumb
    mov r0, #42
    blx 1f
    ldr r1, =result
    str r0, [r1]
    done
    .thumb
1:  svc #0xAB
    bx lr
    .arm

    program test_high_vectors
    ldr r0, =0xFFFF0000
    ldr r1, =vectors
    ldr r2, =0xE59FF018             @ ldr pc, [pc, #24]
    str r2, [r0, #8]
    ldr r2, =on_svc
    str r2, [r0, #40]
    mrc p15, 0, r1, c1, c0, 0
    orr r1, r1, #(1 << 13)
    mcr p15, 0, r1, c1, c0, 0
    svc #0
    done

    program test_abort_in_handler
    ldr r0, =1f
    ldr r1, =0x300000
    str r0, [r1, #56]
    ldr r0, =0xE59FF020             @ ldr pc, [pc, #32]
    str r0, [r1, #16]
    mcr p15, 0, r1, c12, c0, 0
    ldr r2, =NOBODY
    ldr r3, [r2]
1:  ldr r3, [r2]
    done

    @ Sends aborts of data to \handler.
    .macro data_aborts_to handler
    ldr r0, =\handler
    ldr r1, =0x300000
    str r0, [r1, #56]
    ldr r0, =0xE59FF020             @ ldr pc, [pc, #32]
    str r0, [r1, #16]
    mcr p15, 0, r1, c12, c0, 0
    ldr r2, =NOBODY
    .endm

    program test_spin_in_handler
    data_aborts_to 1f
    ldr r3, [r2]
1:  b 1b

    program test_thumb_spin_in_handler
    data_aborts_to 1f + 1
    ldr r3, [r2]
    .thumb
1:  b.n 1b
    nop
    .arm

    program test_wide_spin_in_handler
    data_aborts_to 1f + 1
    ldr r3, [r2]
    .thumb
1:  b.w 1b
    .arm

    program test_spin_with_interrupts
    data_aborts_to 1f
    ldr r3, [r2]
1:  cpsie if
2:  b 2b

    program test_sleep_in_handler
    data_aborts_to 1f
    ldr r3, [r2]
1:  wfi
    b 1b

    program test_slow_handler           @ 5 ms
    data_aborts_to 1f
    ldr r3, [r2]
    done
1:  ldr r4, =2000000
2:  subs r4, r4, #1
    bne 2b
    subs pc, lr, #4

    program test_many_aborts
    data_aborts_to 2f
1:  ldr r3, [r2]
    b 1b
2:  mov r4, #100
3:  subs r4, r4, #1
    bne 3b
    subs pc, lr, #4

    program test_spin_behind_aborts
    ldr r2, =NOBODY
    ldr r3, [r2]
    ldr r3, [r2]
    b .

    program test_reset
    ldr r0, =result
    ldr r1, [r0]
    add r1, r1, #1
    str r1, [r0]
    cmp r1, #2
    beq 1f
    ldr r2, =0xFFD05004
    mov r3, #2
    str r3, [r2]
    b .
1:  done

    .thumb
    .global test_thumb_abort
    .type test_thumb_abort, %function
    .thumb_func
test_thumb_abort:
    ldr r11, =1f
    ldr r3, =NOBODY
    nop
    .global at_thumb_abort
    .thumb_func
at_thumb_abort:
    ldr r2, [r3]
1:  nop
    ldr r0, =result
    mrs r1, cpsr
    str r1, [r0]
    cpsid if
    wfi
    b .
    .ltorg

    .arm
    @ Sections of 1 MB, each where it is: RAM cached, from 0xC0000000 on device memory, and
    @ 0x40000000 to 0xBFFFFFFF not there.
    program test_mmu
    ldr r0, =0x4000
    ldr r1, =0x00000C0E             @ section, full access, write-back
    mov r2, #0
1:  cmp r2, #0x40000000
    ldreq r1, =0x00000C06           @ shared device
    orr r3, r2, r1
    cmp r2, #0x40000000
    blo 2f
    cmp r2, #0xC0000000
    movlo r3, #0
2:  str r3, [r0], #4
    adds r2, r2, #0x100000
    bne 1b
    ldr r0, =0x4000
    mcr p15, 0, r0, c2, c0, 0       @ TTBR0
    mov r0, #1
    mcr p15, 0, r0, c3, c0, 0       @ DACR: client of domain 0
    mov r0, #0
    mcr p15, 0, r0, c8, c7, 0       @ TLB
    mcr p15, 0, r0, c7, c5, 0       @ instruction cache
    mcr p15, 0, r0, c7, c10, 4
    mrc p15, 0, r0, c1, c0, 0
    ldr r1, =0x1805                 @ I, Z, C, M
    orr r0, r0, r1
    mcr p15, 0, r0, c1, c0, 0
    isb
    ldr r0, =PROBE
    ldr r1, =0x1234
    str r1, [r0]
    ldr r2, [r0]
    ldr r3, =result
    str r2, [r3]
    ldr r1, =NOBODY
    .global at_mmu_abort
at_mmu_abort:
    ldr r2, [r1, #12]!
    stmib r3, {r1, r2}
    ldr r11, =3f
    bx r1
3:  done
