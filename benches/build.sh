#!/usr/bin/env bash
# What the program costs to build: processor seconds of a clean build, crates, size of the program.
#
#     benches/build.sh [PROFILE]
#
# Builds the profile, release where none is named, into a folder of its own, which is removed again.
set -euo pipefail
cd "$(dirname "$0")/.."
profile=${1:-release}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cargo fetch --quiet
TIMEFORMAT='%U %S %R'
{ time CARGO_TARGET_DIR=$work cargo build --profile "$profile" --quiet; } 2>"$work/log" || { cat "$work/log"; exit 1; }
times=$(tail -n 1 "$work/log")
awk -v times="$times" 'BEGIN { split(times, t); printf "%-24s %.0f s of the processors, %.0f s by the clock\n", "clean build", t[1] + t[2], t[3] }'
crates=$(cargo tree --prefix none -e normal | sed 's/ (\*)$//' | sort -u | wc -l)
printf '%-24s %s, this one among them\n' "crates" "$crates"
folder=$profile
[ "$profile" != dev ] || folder=debug
size=$(stat -c %s "$work/$folder/stampflow")
printf '%-24s %s bytes\n' "program" "$size"
