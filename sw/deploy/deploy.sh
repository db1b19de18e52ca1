#!/bin/sh
# deploy.sh - bitstream and program to a board's Linux over ssh, or back: make deploy, make rollback
#
#   deploy.sh [--dry-run] [--force] [--foreground] deploy|rollback|arguments
#
# Reads from the environment, where make puts what stands on its command line:
#
#   BOARD       user@host, or a name of ~/.ssh/config
#   RBF         build/bitstream/de1_soc.rbf
#   MSEL        01010: what the switches must be; 00000 for an uncompressed RBF
#   FIRMWARE    build/firmware/collide-linux
#   BUILD       build: where the overlays, and the two files above, are
#   SSH_CONFIG  ssh's own file of options
#   DRY_RUN, FORCE, FOREGROUND: 1 is the same as the option
#
# Exit 0: the version runs.  1: it does not; the last line says what does.  2: wrong usage.  3: a
# file or a tool is missing here.  README.md tells what a cut leaves at each step.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
build=${BUILD:-$(cd "$here/../.." && pwd)/build}
rbf=${RBF:-$build/bitstream/de1_soc.rbf}
firmware=${FIRMWARE:-$build/firmware/collide-linux}
want_msel=${MSEL:-01010}
dry_run=${DRY_RUN:-}
force=${FORCE:+force}
mode=${FOREGROUND:+foreground}
action=
step=0
terminal=  # -t: the program in the foreground ends with Ctrl-C

. "$here/ssh.sh"

fail() {  # CODE MESSAGE
    printf 'deploy: %s\n' "$2" >&2
    exit "$1"
}

# Prints the next step, and notes what the board runs if the connection is cut from now on.
step() {
    step=$((step + 1))
    doing=$1
    promise=$2
    echo "[$step] $doing"
}

read_arguments() {
    for argument; do
        case $argument in
        --dry-run) dry_run=1 ;;
        --force) force=force ;;
        --foreground) mode=foreground ;;
        deploy | rollback | arguments)
            [ -z "$action" ] || fail 2 "expected one of deploy, rollback; got both"
            action=$argument
            ;;
        *) fail 2 "expected [--dry-run] [--force] [--foreground] ACTION, not \"$argument\"" ;;
        esac
    done
    [ -n "$action" ] || fail 2 "expected deploy or rollback"
    [ -n "${BOARD:-}" ] || fail 2 "which board? BOARD=user@host"
    case $BOARD in
    -* | *[!A-Za-z0-9@._:%-]*) fail 2 "BOARD=\"$BOARD\" is not of the form user@host" ;;
    esac
    case $want_msel in
    [01][01][01][01][01]) ;;
    *) fail 2 "MSEL=\"$want_msel\" is not five binary digits" ;;
    esac
    force=${force:-no}
    mode=${mode:-service}
    command -v ssh >/dev/null || fail 3 "ssh is not on the PATH (package openssh-client)"
    [ "$action" = rollback ] || [ -s "$rbf" ] ||
        fail 3 "no bitstream at $rbf: make bitstream, or RBF=file"
}

# The version as a folder; its name is made of its sums.
stage() {
    stage=$scratch/version
    mkdir "$stage"
    [ -s "$firmware" ] || fail 3 "no program at $firmware: make firmware"
    cp -- "$rbf" "$stage/de1_soc.rbf"
    cp -- "$firmware" "$stage/collide-linux"
    chmod 755 "$stage/collide-linux"
    for node in base_fpga_region base-fpga-region fpga-region; do
        [ -s "$build/deploy/$node.dtbo" ] || fail 3 "no overlays in $build/deploy: make firmware"
        cp "$build/deploy/$node.dtbo" "$stage/"
    done
    cp "$scratch/board.sh" "$stage/"
    (cd "$stage" && sha256sum -- * >SHA256SUMS)
    id=$(sha256sum <"$stage/SHA256SUMS" | cut -c1-12)
    need_kib=$(($(du -sk "$stage" | cut -f1) + 1024))
}

send_script() {
    run_ssh "sh -c 'd=\"\${DE1SIM_ROOT:-}/run/de1sim\"; umask 022; mkdir -p \"\$d\" &&\
 cat >\"\$d/board.sh.new\" && mv -f \"\$d/board.sh.new\" \"\$d/board.sh\"'" <"$scratch/board.sh"
}

send_version() {
    tar -C "$stage" --format=ustar --owner=root:0 --group=root:0 -cf - . | on_board receive "$id"
}

in_foreground() {
    step "run the program here until it ends (Ctrl-C)" \
        "the new version; the program ends with its terminal"
    [ ! -t 0 ] || terminal=-t
    on_board foreground
}

deploy() {
    stage
    echo "version $id: $rbf and $firmware, $need_kib KiB"
    step "look at the board" "what it ran before"
    on_board check "$want_msel" "$need_kib" "$force" </dev/null
    step "copy the version, compare its sums there" "what it ran before"
    if [ -n "$dry_run" ] || ! on_board has "$id" </dev/null; then
        send_version
    else
        echo "version $id is there already"
    fi
    step "load, check the system ID, switch, start; back to the version before if that fails" \
        "the new version or the one before; what it has begun it ends alone"
    on_board activate "$id" "$mode" </dev/null
}

rollback() {
    step "load the version before, check the system ID, switch, start" \
        "one of the two; what it has begun it ends alone"
    on_board rollback "$mode" </dev/null
}

finish() {
    end=$?
    close_ssh
    rm -rf "$scratch"
    exit $end
}

read_arguments "$@"
[ "$action" != arguments ] || exit 0
# Not in TMPDIR: ssh's socket has room for 100 characters.
scratch=$(mktemp -d /tmp/de1sim.XXXXXX)
trap finish EXIT
trap 'exit 130' HUP INT TERM
cat "$here/board/facts.sh" "$here/board/fpga.sh" "$here/board/versions.sh" "$here/board/main.sh" \
    >"$scratch/board.sh"

step "connect to $BOARD and send board.sh" "what it ran before"
send_script
"$action"
if [ -z "$dry_run" ] && [ "$mode" = service ] && ! on_board systemd </dev/null; then
    echo "no systemd there"
    mode=foreground
fi
[ "$mode" = service ] || in_foreground
