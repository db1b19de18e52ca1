#!/usr/bin/env bash
# options_test.sh DE1SIM FOLDER - FOLDER/de1sim.1 and FOLDER/completion.bash know what --help says
set -euo pipefail
de1sim=$1 folder=$2

page=$(sed 's/\\-/-/g' "$folder/de1sim.1")
commands="run test live build check check-board compare merge"
options=$(for command in $commands; do "$de1sim" "$command" --help; done |
    grep -o -E '^ +(-h,)?--[a-z-]+' | grep -o -E -- '--[a-z-]+' | sort -u)
[ "$(wc -w <<< "$options")" -gt 15 ]
for option in $options; do
    grep -q -E -- "$option([^a-z-]|$)" <<< "$page" || {
        echo "de1sim.1 does not mention $option"
        exit 1
    }
done

# shellcheck source=/dev/null
. "$folder/completion.bash"
offered() {  # WORDS...: what is offered for the last of them
    COMP_WORDS=("$@")
    COMP_CWORD=$(($# - 1))
    _de1sim "$1"
    echo "${COMPREPLY[*]}"
}
[ "$(offered "$de1sim" run --cpu n)" = native ]
[ "$(offered "$de1sim" run --fpga)" = --fpga-memory ]
[ "$(offered "$de1sim" run --frames l)" = last ]
[[ " $(offered "$de1sim" ch) " == *" check-board "* ]]
[ "$(offered "$de1sim" compare --o)" = "" ]
[ "$(offered "$de1sim" run -- | tr ' ' '\n' | sort | tr '\n' ' ')" = \
  "$("$de1sim" run --help | grep -o -E '^ +(-h,)?--[a-z-]+' | grep -o -E -- '--[a-z-]+' | sort |
    tr '\n' ' ')" ]
