#!/usr/bin/env bash
# Instructions of whole runs, and of the solver in them, counted by valgrind: unlike times they are the same on a busy machine.
#
#     benches/instructions.sh [CASE...]
#
# Needs valgrind and a release build, which it makes where there is none. Without cases: Woo, quickstart and Chalmers.
set -euo pipefail
cd "$(dirname "$0")/.."
cases=("$@")
[ ${#cases[@]} -gt 0 ] || cases=(cases/woo_hemispherical.toml cases/quickstart.toml cases/chalmers_cup.toml)
cargo build --release --quiet
program=${CARGO_TARGET_DIR:-target}/release/stampflow
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
printf '%-44s %14s %14s\n' "case" "run" "of it solver"
for case in "${cases[@]}"; do
    valgrind --tool=callgrind --callgrind-out-file="$work/counts" \
        "$program" run "$case" --out "$work/out" --quiet >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
    callgrind_annotate --inclusive=yes --threshold=100 "$work/counts" >"$work/functions"
    whole=$(awk '/PROGRAM TOTALS/ { print $1 }' "$work/functions")
    # Inclusive counts come largest first: the solver's entry is the first of its functions.
    solver=$(awk '/stampflow::solver::/ { print $1; exit }' "$work/functions")
    printf '%-44s %14s %14s\n' "$case" "$whole" "${solver:--}"
done
