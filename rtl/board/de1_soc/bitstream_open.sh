#!/bin/sh
# bitstream_open.sh - the same project by Yosys and nextpnr-mistral: make bitstream-open
#
#   build/bitstream-open/de1_soc.rbf   uncompressed, for JTAG and MSEL 00000
#
# What these tools cannot do: the PLL (25 MHz is CLOCK_50 divided by two) and the bridges to the
# processor (open_hps.v paints colour bars in its place).  With --netlist it stops before
# nextpnr-mistral.  Exit 3 where a tool is not installed.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
out=../../../build/bitstream-open

tools="yosys nextpnr-mistral"
[ "${1:-}" = --netlist ] && tools=yosys
for tool in $tools; do
    if ! command -v "$tool" >/dev/null; then
        echo "make bitstream-open: $tool is not on the PATH" >&2
        exit 3
    fi
done

cd "$here"
mkdir -p "$out"
# list NAME PROJECT: the values of this assignment in the project, in a line
list() { sed -n "s/^set_global_assignment -name $1 //p" "$2" | tr '\n' ' '; }

includes=$(list SEARCH_PATH de1_soc.qsf | sed 's/[^ ]*/-I&/g; s/-I *$//')
removed=$(sed -n 's/^set_global_assignment -remove -name VERILOG_FILE //p' open.qsf)
files=$(list VERILOG_FILE de1_soc.qsf | sed "s, $removed , ,")$(list VERILOG_FILE open.qsf)
yosys -q -l "$out/yosys.log" -p "
    read_verilog $includes $files
    hierarchy -check -top de1_soc_top; proc; flatten; hierarchy -top de1_soc_top
    tribuf; simplemap t:\$tribuf; opt_clean
    iopadmap -bits -outpad MISTRAL_OB I:PAD -inpad MISTRAL_IB O:PAD \
        -toutpad MISTRAL_IO OE:O:PAD -tinoutpad MISTRAL_IO OE:O:I:PAD A:top
    synth_intel_alm -family cyclonev -top de1_soc_top -noiopad
    delete t:\$scopeinfo
    write_json $out/de1_soc.json"
[ "${1:-}" = --netlist ] && exit

nextpnr-mistral --device 5CSEMA5F31C6 --json "$out/de1_soc.json" --qsf de1_soc.qsf --freq 25 \
    --rbf "$out/de1_soc.rbf"
echo "written: build/bitstream-open/de1_soc.rbf (colour bars: no PLL, no processor)"
