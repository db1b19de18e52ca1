# fpga.sh - second part of board.sh: FPGA, bridges, and the program that runs beside them

# bridges on|off: both from the processor to the FPGA
bridges() {
    value=0
    [ "$1" = off ] || value=1
    case $(way_to_bridges) in
    registers)
        reset=$(peek $BRIDGE_RESET)
        if [ "$1" = off ]; then
            poke $BRIDGE_RESET $((reset | 3))
        else
            poke $BRIDGE_RESET $((reset & ~3)) && poke $L3_REMAP 0x19
        fi
        ;;
    /sys*)
        echo $value >"$sys/class/fpga-bridge/hps2fpga/enable" &&
            echo $value >"$sys/class/fpga-bridge/lwhps2fpga/enable"
        ;;
    *) say "bridges: nothing here switches them, left as the kernel has them" ;;
    esac
}

# The kernel finds both files by name in /lib/firmware.
write_overlay() {
    mkdir -p "$root/lib/firmware" &&
        point "$root/lib/firmware/de1sim.rbf" "$1/de1_soc.rbf" &&
        point "$root/lib/firmware/de1sim.dtbo" "$1/$(region).dtbo" || return 1
    [ ! -d "$overlays/de1sim" ] || rmdir "$overlays/de1sim" || return 1
    mkdir "$overlays/de1sim" && printf %s de1sim.dtbo >"$overlays/de1sim/path"
}

is_loaded() {
    is_operating || return 1
    [ ! -e "$overlays/de1sim/status" ] || [ "$(cat "$overlays/de1sim/status")" = applied ]
}

# load ID: this version's bitstream, then the bridges, then the system ID
load() {
    folder=$opt/versions/$1
    way=$(way_to_load) || return 1
    rm -f "$run/loaded"
    say "bridges off"
    bridges off || return 1
    say "loads $1 by $way"
    if [ "$way" = overlay ]; then
        write_overlay "$folder" || say "the kernel refuses the overlay"
    else
        cat "$folder/de1_soc.rbf" >"$root/dev/fpga0" || say "the kernel refuses the bitstream"
    fi
    tries=0
    until is_loaded; do
        tries=$((tries + 1))
        if [ $tries -gt 10 ]; then
            say "the FPGA is not operating but: $(fpga_state)"
            return 1
        fi
        sleep 1
    done
    say "operating; bridges on"
    bridges on || return 1
    matches "$1" || return 1
    echo "$1" >"$run/loaded"
}

# matches ID: the program of this version finds its own register map in the FPGA
matches() {
    if found=$("$opt/versions/$1/collide-linux" --check 2>&1); then
        say "$found"
    else
        say "wrong system ID or no answer: $found"
        return 1
    fi
}

# What systemd calls before the program, also after a power cut: loads unless that is done.
boot() {
    mkdir -p "$run"
    id=$(current) || die "no version is installed"
    if [ "$(cat "$run/loaded" 2>/dev/null)" = "$id" ] && is_operating && matches "$id"; then
        return 0
    fi
    load "$id" || die "version $id cannot be loaded"
}

write_unit() {
    mkdir -p "${unit%/*}" && cat >"$unit.new" <<EOT && mv -f "$unit.new" "$unit"
[Unit]
Description=de1sim: bitstream and program of /opt/de1sim/current

[Service]
ExecStartPre=/bin/sh $opt/current/board.sh boot
ExecStart=$opt/current/collide-linux
Restart=on-failure
RestartSec=2

[Install]
WantedBy=multi-user.target
EOT
}

start() {
    say "starts the program"
    write_unit && systemctl daemon-reload && systemctl enable de1sim 2>/dev/null &&
        systemctl restart de1sim || return 1
    sleep 1
    systemctl is-active de1sim >/dev/null
}

# foreground: the program until it ends; its process is known to stop()
foreground() {
    [ ! -e "$unit" ] || ! has_systemd || systemctl stop de1sim
    mkdir -p "$run"
    boot
    echo $$ >"$run/pid"
    exec "$opt/current/collide-linux"
}

stop() {
    if [ -e "$unit" ] && has_systemd; then
        systemctl stop de1sim || return 1
    fi
    pid=$(cat "$run/pid" 2>/dev/null) || return 0
    tries=0
    while grep -q collide-linux "/proc/$pid/cmdline" 2>/dev/null; do
        tries=$((tries + 1))
        case $tries in 1) kill "$pid" ;; 5) kill -9 "$pid" ;; 10) return 1 ;; esac
        sleep 1
    done
    rm -f "$run/pid"
}
