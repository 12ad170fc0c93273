#!/usr/bin/env bash
# Instructions of whole runs, and of the solver in them, counted by valgrind: unlike times they are the same on a busy machine.
#
#     benches/instructions.sh [CASE...]
#     benches/instructions.sh --cups COUNT
#
# Needs valgrind and a release build, which it makes where there is none. Without cases: Woo, quickstart and Chalmers. With
# --cups: of one of the first COUNT designs of `benches/throughput.rs`, on average.
set -euo pipefail
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# count COMMAND...: instructions of the whole run, and of the solver in it.
count() {
    valgrind --tool=callgrind --callgrind-out-file="$work/counts" "$@" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
    callgrind_annotate --inclusive=yes --threshold=100 "$work/counts" >"$work/functions"
    whole=$(awk '/PROGRAM TOTALS/ { print $1 }' "$work/functions")
    # Inclusive counts come largest first: the solver's entry is the first of its functions.
    solver=$(awk '/stampflow::solver::/ { print $1; exit }' "$work/functions")
}
if [ "${1:-}" = --cups ]; then
    cups=${2:?"how many?"}
    bench=$(cargo bench --bench throughput --no-run 2>&1 | sed -n 's/.*(\(.*throughput-.*\))$/\1/p')
    count "$bench" --count "$cups" --meshes 0
    awk -v whole="${whole//,/}" -v solver="${solver//,/}" -v n="$cups" \
        'BEGIN { printf "a cup of %d: %.0f instructions, of them the solver %.0f\n", n, whole / n, solver / n }'
    exit
fi
cases=("$@")
[ ${#cases[@]} -gt 0 ] || cases=(cases/woo_hemispherical.toml cases/quickstart.toml cases/chalmers_cup.toml)
cargo build --release --quiet
program=${CARGO_TARGET_DIR:-target}/release/stampflow
printf '%-44s %14s %14s\n' "case" "run" "of it solver"
for case in "${cases[@]}"; do
    count "$program" run "$case" --out "$work/out" --quiet
    printf '%-44s %14s %14s\n' "$case" "$whole" "${solver:--}"
done
