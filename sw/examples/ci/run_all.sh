#!/bin/sh
# run_all.sh [SCENARIO...] - plays scenarios, each into out/NAME; without names, all that are one
# folder below.  Exit code 1 if one of them fails, after all have run.
failed=0
[ $# -gt 0 ] || set -- */*.yaml
for scenario in "$@"; do
    name=$(basename "$scenario" .yaml)
    echo "$name"
    de1sim run --quiet --frames last --out "out/$name" "$scenario" || failed=1
done
exit $failed
