#!/bin/sh
# Runs a benchmark and keeps what it prints, with machine and date, for the page of the book that shows it:
#
#   benches/measured.sh campaign -- --count 1000 --seed 7      # benches/measured/campaign_count_1000_seed_7.md
#
# A page shows the file by `<!-- file: ... -->` and `<!-- printed: cat ... -->` (tests/suite/book.rs), so that it cannot say
# anything else; figures that do not depend on the machine are the same after every run, ratios of times nearly so.
set -eu
cd "$(dirname "$0")/.."
name=$(printf %s "$*" | sed 's/--profile [a-z]*//; s/[^A-Za-z0-9]\{1,\}/_/g')
printed=$(cargo bench --quiet --bench "$@")
cpu=$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1)
mkdir -p benches/measured
{
    echo "\`cargo bench --bench $*\`, $(date -u +%F), $(getconf _NPROCESSORS_ONLN) cores of ${cpu:-an unknown processor}:"
    echo
    # A table of Markdown stays one.
    case $printed in
        *'|---'*) echo "$printed" ;;
        *) printf '```text\n%s\n```\n' "$printed" ;;
    esac
} > "benches/measured/$name.md"
echo "benches/measured/$name.md written"
