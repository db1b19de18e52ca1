#!/usr/bin/env bash
# portable_test.sh BUILD WORK - the archive of make portable plays an example where it is unpacked
set -euo pipefail
build=$1 work=$2 source=$(realpath "$(dirname "$0")/../..")
rm -rf "$work"
mkdir -p "$work/a place"
archive=$("$source/sim/package/portable.sh" "$build" | tail -n 1)
tar -xJf "$archive" -C "$work/a place"
cd "$work/a place"/de1sim-*
env -i bin/de1sim run share/de1sim/examples/first_led/first_led.yaml --quiet --out "$work/out"
env -i PYTHONPATH=lib/python3/dist-packages DE1SIM="$PWD/bin/de1sim" /usr/bin/python3 -B -c '
import de1sim
with de1sim.Board() as board:
    board.wait_text("ready")'

# What projects are built of, and the examples, are all there.
files() { (cd "$1" && find ip examples -name .de1sim -prune -o -type f -print | sort); }
diff <(files share/de1sim/rtl) <(files "$source/rtl")

# Of the machine it takes what every machine has.
elsewhere=$(env -i LD_TRACE_LOADED_OBJECTS=1 bin/de1sim | sed -n 's/.* => \(.*\) (0x.*/\1/p' |
    grep -v "^$PWD/bin/\.\./lib/" | sed 's,.*/,,; s,\.so.*,,' | sort -u | tr '\n' ' ')
[ "$elsewhere" = "libc libgcc_s libm libstdc++ " ] || { echo "$elsewhere"; exit 1; }
ls share/doc/de1sim/licences/libdynarmic* > /dev/null
rm -r "$work" "$archive"
