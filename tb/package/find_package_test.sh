#!/usr/bin/env bash
# find_package_test.sh BUILD WORK - a C++ user's project, with what cmake --install gives
set -euo pipefail
build=$1 work=$2
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
cmake --install "$build" --prefix "$work/a prefix" > /dev/null
cmake -S "$here/blinker" -B "$work/build" "-DCMAKE_PREFIX_PATH=$work/a prefix" > "$work/log"
cmake --build "$work/build" >> "$work/log"

"$work/build/blinker" --version | grep -q '^de1sim '
"$work/build/blinker" run "$here/blinker/blinker.yaml" --quiet --frames none --out "$work/out"
"$work/build/blinker" run "$here/blinker/blinker.yaml" --quiet --frames none --out "$work/out" \
    --trace "$work/waves.fst"
[ -s "$work/waves.fst" ]
"$work/a prefix/bin/de1sim" --version | grep -q '^de1sim '
[ -e "$work/a prefix/share/de1sim/examples/first_led/first_led.yaml" ]
rm -r "$work"
