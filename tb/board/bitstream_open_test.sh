#!/bin/sh
# bitstream_open_test.sh SOURCE SCRATCH - bitstream_open.sh without its tools, and with Yosys and a
# stand-in for nextpnr-mistral, which gets cells that nextpnr-mistral knows.
set -eu
source=$1
scratch=$2/bitstream_open_test
copy="$scratch/a folder"
script="$copy/rtl/board/de1_soc/bitstream_open.sh"
. "$(dirname "$0")/bitstream_bench.sh"
mkdir -p "$copy"
cp -r "$source/rtl" "$copy/"

only sh dirname mkdir sed tr
misses yosys
only yosys
misses nextpnr-mistral

cat >"$scratch/tools/nextpnr-mistral" <<'EOT'
#!/bin/sh
for word; do [ "$last" = --rbf ] && touch "$word"; last=$word; done
EOT
chmod +x "$scratch/tools/nextpnr-mistral"
run "$scratch/tools:$PATH"
out="$copy/build/bitstream-open"
[ $code = 0 ] || fail "with the tools: exit $code"
[ -f "$out/de1_soc.rbf" ] || fail "no bitstream"
cells=$(/usr/bin/python3 -c 'import json, sys
top = json.load(open(sys.argv[1]))["modules"]["de1_soc_top"]
print(*sorted({cell["type"] for cell in top["cells"].values()}), sep="\n")' "$out/de1_soc.json")
[ "$(echo "$cells" | grep -c MISTRAL_M10K)" = 1 ] || fail "the picture's memory is gone"
if echo "$cells" | grep -qv '^MISTRAL_'; then fail "unknown cells: $cells"; fi

cat >"$scratch/tools/nextpnr-mistral" <<'EOT'
#!/bin/sh
echo "ERROR: unsupported device" >&2
exit 255
EOT
# Saves a minute: Yosys would make the same netlist again.
ln -s "$(command -v true)" "$scratch/tools/yosys"
rm "$out/de1_soc.rbf"
run "$scratch/tools:$PATH"
[ $code = 255 ] || fail "no data for the device: exit $code"
grep -q "written" "$scratch/said" && fail "no data for the device: says that it wrote"
echo "bitstream_open.sh: all as promised"
