#!/bin/sh
# bitstream.sh - compiles the Quartus project into build/bitstream/: make bitstream
#
#   de1_soc.rbf        compressed, for the HPS to load      MSEL 01010
#   de1_soc_jtag.rbf   uncompressed, for JTAG and           MSEL 00000
#
# Prints how much of the device is used and the worst slack.  Exit 1 where timing is not met, 3
# where Quartus is not installed.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
out=$here/../../../build/bitstream

for tool in quartus_sh quartus_cpf; do
    if ! command -v "$tool" >/dev/null; then
        echo "make bitstream: $tool is not on the PATH (Quartus Prime Lite will do)" >&2
        exit 3
    fi
done

mkdir -p "$out"
(cd "$here" && quartus_sh --flow compile de1_soc)
grep -E 'Logic utilization|Total registers|Total block memory|RAM Blocks|DSP|PLL' \
    "$out/de1_soc.fit.summary"

# The smallest of all "Slack : -0.123", over every corner and check.
worst=$(awk '$1 == "Slack" { if (n++ == 0 || $3 + 0 < w) w = $3 + 0 } END { if (n) print w }' \
    "$out/de1_soc.sta.summary")
if [ -z "$worst" ]; then
    echo "make bitstream: no slack in $out/de1_soc.sta.summary: was timing analysed?" >&2
    exit 1
fi
echo "worst slack: $worst ns"
if awk "BEGIN { exit !($worst < 0) }"; then
    echo "make bitstream: timing is not met" >&2
    exit 1
fi

quartus_cpf -c -o bitstream_compression=on "$out/de1_soc.sof" "$out/de1_soc.rbf"
quartus_cpf -c -o bitstream_compression=off "$out/de1_soc.sof" "$out/de1_soc_jtag.rbf"
echo "written: build/bitstream/de1_soc.rbf, build/bitstream/de1_soc_jtag.rbf"
