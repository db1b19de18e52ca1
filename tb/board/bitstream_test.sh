#!/bin/sh
# bitstream_test.sh PROJECT SCRATCH - bitstream.sh without Quartus, and with a stand-in that reports
# what Quartus would: timing met, missed, not analysed, a compilation that fails.
set -eu
project=$1
scratch=$2/bitstream_test
copy="$scratch/a folder/rtl/board/de1_soc"
script="$copy/bitstream.sh"
. "$(dirname "$0")/bitstream_bench.sh"
mkdir -p "$copy"
cp "$project/bitstream.sh" "$copy/"
out="$scratch/a folder/build/bitstream"

only sh dirname mkdir sed awk cat touch
misses quartus_sh

cat >"$scratch/tools/quartus_sh" <<EOT
#!/bin/sh
[ "\$SLACK" = broken ] && exit 2
echo "Logic utilization (in ALMs) : 2,000 / 32,070 ( 6 % )" >"$out/de1_soc.fit.summary"
for slack in \$SLACK; do
    printf 'Type  : Slow 1100mV 85C Model Setup\\nSlack : %s\\nTNS   : 0.000\\n' "\$slack"
done >"$out/de1_soc.sta.summary"
touch "$out/de1_soc.sof"
EOT
cat >"$scratch/tools/quartus_cpf" <<'EOT'
#!/bin/sh
[ -f "$4" ] && touch "$5"
EOT
chmod +x "$scratch/tools/"*
tools="$scratch/tools:$PATH"

SLACK="3.250 0.125 11.000"; export SLACK; run "$tools"
[ $code = 0 ] || fail "timing met: exit $code"
grep -q "worst slack: 0.125 ns" "$scratch/said" || fail "timing met: the worst slack is 0.125"
grep -q "Logic utilization" "$scratch/said" || fail "timing met: use of the device not printed"
[ -f "$out/de1_soc.rbf" ] || fail "timing met: no de1_soc.rbf"
[ -f "$out/de1_soc_jtag.rbf" ] || fail "timing met: no de1_soc_jtag.rbf"

rm "$out"/*.rbf

SLACK="3.250 -0.031 1.000"; run "$tools"
[ $code = 1 ] || fail "timing missed: exit $code, not 1"
grep -q "worst slack: -0.031 ns" "$scratch/said" || fail "timing missed: slack not printed"
[ ! -f "$out/de1_soc.rbf" ] || fail "timing missed: a bitstream all the same"

SLACK=""; run "$tools"
[ $code = 1 ] || fail "not analysed: exit $code, not 1"

SLACK=broken; run "$tools"
[ $code != 0 ] || fail "compilation failed: exit 0"
echo "bitstream.sh: all as promised"
