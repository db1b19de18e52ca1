#!/bin/sh
# ssh.sh - part of deploy.sh: one connection to the board for all steps, host key checked
#
# StrictHostKeyChecking=yes: an unknown key ends the deployment and is never learnt.  ssh itself
# asks for a password where no key is at hand, once, at the terminal.

# run_ssh COMMAND: its exit code; if the connection broke, exits with what step() noted
run_ssh() {
    if [ -n "$dry_run" ]; then
        printf '    ssh %s %s\n' "$BOARD" "$1"
        return 0
    fi
    set -- -o StrictHostKeyChecking=yes -o ConnectTimeout=10 -o ServerAliveInterval=5 \
        -o ServerAliveCountMax=3 -o ControlMaster=auto -o ControlPersist=60 \
        -o "ControlPath=$scratch/ssh" -o LogLevel=ERROR $terminal -- "$BOARD" "$1"
    [ -z "${SSH_CONFIG:-}" ] || set -- -F "$SSH_CONFIG" "$@"
    code=0
    ssh "$@" || code=$?
    [ $code != 255 ] || fail 1 "no connection at step $step ($doing). The board runs $promise.\
 The same command again goes on."
    return $code
}

# on_board ARGUMENTS: one command of board.sh; every argument is made of letters and digits
on_board() {
    run_ssh "sh -c 'exec sh \"\${DE1SIM_ROOT:-}/run/de1sim/board.sh\" $*'"
}

close_ssh() {
    [ ! -S "$scratch/ssh" ] ||
        ssh -o "ControlPath=$scratch/ssh" -O exit -- "$BOARD" 2>/dev/null || :
}
