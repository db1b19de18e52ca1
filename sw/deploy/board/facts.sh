#!/bin/sh
# facts.sh - first part of board.sh: paths and registers of the board, and queries of its state
#
# DE1SIM_ROOT is put before every path, so that in tests a folder can stand for the board.  Needs no
# more than busybox: sh, tar, sha256sum, flock, mv -T.  Changes nothing but /run/de1sim.
set -u
umask 022

root=${DE1SIM_ROOT:-}
opt=$root/opt/de1sim
run=$root/run/de1sim
sys=$root/sys
overlays=$sys/kernel/config/device-tree/overlays
unit=$root/etc/systemd/system/de1sim.service

FPGA_STAT=0xFF706000     # Cyclone V HPS TRM, FPGA manager: mode 2:0, MSEL 7:3
BRIDGE_RESET=0xFFD0501C  # reset manager, brgmodrst: hps2fpga 0, lwhps2fpga 1; 1 is off
L3_REMAP=0xFF800000      # write-only: RAM at 0, hps2fpga and lwhps2fpga visible are 0, 3, 4

# A closed output is no reason to stop.
say() {
    printf 'board: %s\n' "$1" 2>/dev/null || :
}

die() {
    printf 'board: %s\n' "$1" >&2 || :
    exit 1
}

has() { command -v "$1" >/dev/null 2>&1; }

has_systemd() { [ -d "$root/run/systemd/system" ]; }

# peek ADDRESS: the word there as 0x..., where a tool for it exists
peek() {
    if has devmem; then
        devmem "$1" 32
    elif has devmem2; then
        devmem2 "$1" w | sed -n 's/.*): *\(0x[0-9A-Fa-f]*\).*/\1/p'
    else
        return 1
    fi
}

# poke ADDRESS WORD
poke() {
    if has devmem; then
        devmem "$1" 32 "$2"
    elif has devmem2; then
        devmem2 "$1" w "$2" >/dev/null
    else
        return 1
    fi
}

# The switches MSEL4-0 as five digits.
msel() {
    stat=$(peek $FPGA_STAT) || return 1
    case $stat in 0x*) ;; *) return 1 ;; esac
    digits=
    for bit in 7 6 5 4 3; do
        digits=$digits$((stat >> bit & 1))
    done
    echo "$digits"
}

# The device tree's node of the whole FPGA, whose name depends on the kernel.
region() {
    for node in base_fpga_region base-fpga-region fpga-region; do
        if [ -d "$root/proc/device-tree/soc/$node" ]; then
            echo "$node"
            return 0
        fi
    done
    return 1
}

way_to_load() {
    if [ -d "$overlays" ] && region >/dev/null; then
        echo overlay
    elif [ -e "$root/dev/fpga0" ]; then
        echo device
    else
        return 1
    fi
}

# Of the kernel's FPGA manager: mainline, or the 3.x of the board's maker.
fpga_state() {
    cat "$sys/class/fpga_manager/fpga0/state" 2>/dev/null ||
        cat "$sys/class/fpga/fpga0/status" 2>/dev/null || echo unknown
}

is_operating() {
    case $(fpga_state) in operating | 'user mode') return 0 ;; *) return 1 ;; esac
}

way_to_bridges() {
    if [ -e "$sys/class/fpga-bridge/lwhps2fpga/enable" ]; then
        echo "/sys/class/fpga-bridge"
    elif peek $BRIDGE_RESET >/dev/null; then
        echo "registers"
    else
        return 1
    fi
}

# KiB that are free where the versions lie.
free_kib() {
    place=$root/
    [ ! -d "$opt" ] || place=$opt
    free=$(df -Pk "$place" 2>/dev/null |
        sed -n '2s/^[^ ]*  *[0-9]*  *[0-9]*  *\([0-9]*\) .*/\1/p')
    # busybox's df knows no place below a root that is not mounted, as in a chroot.
    [ -n "$free" ] || free=$(stat -f -c '%a %S' "$place" | {
        read -r blocks size
        echo $((blocks * (size / 512) / 2))
    })
    echo "$free"
}

# point LINK TO: atomically; at every moment the link points to the old target or to the new one
point() {
    rm -f "$1.new"
    ln -s "$2" "$1.new" && mv -fT "$1.new" "$1"
}

# check MSEL KIB FORCE: prints what there is; an error where a bitstream cannot be loaded
check() {
    way=$(way_to_load) || way=none
    switches=$(msel) || switches=unknown
    free=$(free_kib)
    say "kernel $(uname -r), FPGA manager $(cat "$sys/class/fpga_manager/fpga0/name" 2>/dev/null ||
        echo 'without a name'), state $(fpga_state)"
    say "loads by $way, MSEL $switches, bridges by $(way_to_bridges || echo 'the kernel alone')"
    say "free $free KiB, needed $2 KiB; current version $(current || echo none)"

    [ -n "$root" ] || [ "$(id -u)" = 0 ] || die "not root: log in as root@..."
    for tool in tar sha256sum flock; do
        has $tool || die "$tool is missing on the board"
    done
    point "$run/probe" . 2>/dev/null || die "mv cannot replace a link on this board (no -T)"
    [ "$way" != none ] || die "neither device-tree overlays nor /dev/fpga0: this Linux cannot load\
 the FPGA; the boot loader can (sw/deploy/README.md, From the SD card)"
    [ "$free" -ge "$2" ] || die "no space: $free KiB are free, $2 KiB are needed"
    if [ "$switches" = unknown ]; then
        [ "$3" = force ] || die "MSEL cannot be read (neither devmem nor devmem2 here): look that\
 the switches are $1, then FORCE=1"
    elif [ "$switches" != "$1" ]; then
        die "MSEL is $switches, this bitstream wants $1: set SW10, below the board"
    fi
}
