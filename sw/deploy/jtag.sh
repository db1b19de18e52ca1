#!/bin/sh
# jtag.sh [--dry-run] - the uncompressed bitstream over the board's USB-Blaster: make deploy-jtag
#
# RBF is build/bitstream/de1_soc_jtag.rbf where the environment names none.  Until power is off.
# Exit 3 where openFPGALoader or the bitstream is missing.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
rbf=${RBF:-$(cd "$here/../.." && pwd)/build/bitstream/de1_soc_jtag.rbf}
dry_run=${DRY_RUN:-}
case ${1:-} in
'') ;;
--dry-run) dry_run=1 ;;
*)
    echo "deploy-jtag: expected nothing or --dry-run, got \"$1\"" >&2
    exit 2
    ;;
esac

if [ ! -s "$rbf" ]; then
    echo "deploy-jtag: no bitstream at $rbf: make bitstream, or RBF=file" >&2
    exit 3
fi
if [ -n "$dry_run" ]; then
    echo "[1] openFPGALoader -b de1Soc $rbf"
    exit 0
fi
if ! command -v openFPGALoader >/dev/null; then
    echo "deploy-jtag: openFPGALoader is not on the PATH (package openfpgaloader)" >&2
    exit 3
fi
case $rbf in -*) rbf=./$rbf ;; esac
exec openFPGALoader -b de1Soc "$rbf"
