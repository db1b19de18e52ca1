# bitstream_bench.sh - sourced, to test $script in the folder $scratch, which is emptied.
#
# Two folders for the PATH: $scratch/none with the few tools that only() names, $scratch/tools for
# stand-ins.
# shellcheck shell=sh disable=SC2154  # they are the caller's
rm -rf "$scratch"
mkdir -p "$scratch/none" "$scratch/tools"

fail() { echo "FAILED: $1"; cat "$scratch/said" 2>&1; exit 1; }
# only TOOL...: these are in none
only() { for tool; do ln -s "$(command -v "$tool")" "$scratch/none/$tool"; done; }
# run PATH: its exit code in $code, its output in the file said
run() { code=0; PATH="$1" "$script" >"$scratch/said" 2>&1 || code=$?; }
# misses TOOL: with the tools of none alone it reports in one line that this one is missing
misses() {
    run "$scratch/none"
    [ "$code" = 3 ] || fail "without $1: exit $code, not 3"
    [ "$(wc -l <"$scratch/said")" = 1 ] || fail "without $1: not a line"
    grep -q "$1 is not on the PATH" "$scratch/said" || fail "without $1: not named"
}
