#!/usr/bin/env bash
# Every crate in the program with its licence, and the texts that come with it, each text once.
#
#     .ci/release/licences.sh TARGET
set -euo pipefail
cd "$(dirname "$0")/../.."

sources=${CARGO_HOME:-$HOME/.cargo}/registry/src
texts=$(mktemp -d)
trap 'rm -rf "$texts"' EXIT
echo "Crates in this program, and their licences."
echo
cargo tree --locked --edges normal --prefix none --format '{p} {l}' --target "$1" |
    sed 's/ (\*)$//; s/ (proc-macro)//' | grep -v '^stampflow ' | sort -u |
    while read -r crate version licence; do
        echo "$crate ${version#v}: $licence"
        for text in "$sources"/*/"$crate-${version#v}"/{LICEN[CS]E,COPYING,NOTICE}*; do
            [ -f "$text" ] || continue
            sum=$(tr -d '\r' <"$text" | cksum | tr ' ' -)
            tr -d '\r' <"$text" >"$texts/$sum.text"
            echo "$crate" >>"$texts/$sum.crates"
        done
    done
for text in "$texts"/*.text; do
    printf '\n\n==== %s\n\n' "$(sort -u "${text%.text}.crates" | paste -sd ' ')"
    cat "$text"
done
