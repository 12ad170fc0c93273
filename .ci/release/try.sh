#!/usr/bin/env bash
# Tries what `.ci/release/build.sh` has made, as its users would: checksums, the program out of archive and package, manual pages,
# completions, the wheel. Installs nothing outside a folder of its own. What this machine has no shell or tool for is named.
#
#     .ci/release/try.sh [FOLDER]
set -euo pipefail
cd "${1:-$(dirname "$0")/../out/release}"
made=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
fail() { echo "release: $*"; exit 1; }
has() { command -v "$1" >/dev/null || { echo "not tried: $1 is not here"; return 1; }; }

(cd "$made" && sha256sum --check --quiet SHA256SUMS)

# PREFIX COMPLETIONS_OF_ZSH: what was unpacked there.
try() {
    local page shown said doc=$1/share/doc/stampflow
    "$1/bin/stampflow" --version
    said=$("$1/bin/stampflow" run "$doc/cases/quickstart.toml" --quiet --out "$work/run")
    grep -q "it does not tear" <<<"$said" || fail "the quickstart says: $said"
    [ -s "$work/run/part.png" ] || fail "no picture"
    rm -r "$work/run"
    grep -q "^miette .*Apache" "$doc/LICENSES-crates.txt" || fail "no licences of the crates"
    if has man; then
        for page in "$1"/share/man/man1/*.gz; do
            shown=$(MANWIDTH=80 man --warnings -l "$page" 2>&1)
            grep -q "SYNOPSIS" <<<"$shown" && ! grep -q "warning:" <<<"$shown" || fail "$page: $(head -5 <<<"$shown")"
        done
    fi
    bash -n "$1/share/bash-completion/completions/stampflow"
    bash -c '. "$1"; complete -p stampflow' - "$1/share/bash-completion/completions/stampflow" >/dev/null
    ! has zsh || zsh -n "$1/share/zsh/$2/_stampflow"
    ! has fish || fish --no-execute "$1/share/fish/vendor_completions.d/stampflow.fish"
    ! has pwsh || pwsh -NoProfile -Command ". '$1/share/stampflow/stampflow.ps1'"
}

tar -xzf "$made"/stampflow-*.tar.gz
try "$(echo "$work"/stampflow-*)" site-functions
if has dpkg; then
    dpkg -x "$made"/stampflow_*.deb deb
    try "$work/deb/usr" vendor-completions
    dpkg-deb --ctrl-tarfile "$made"/stampflow_*.deb | tar -xf - ./md5sums
    (cd deb && md5sum --check --quiet ../md5sums)
fi

python3 -m venv venv
venv/bin/pip install --quiet --disable-pip-version-check "$made"/stampflow-*.whl
venv/bin/python -c 'import stampflow as sf; print("wheel:", sf.new("cup", height="35 mm", punch_diameter="80 mm").solve().verdict)'
