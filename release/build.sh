#!/usr/bin/env bash
# What is shipped for this platform: the program with its manual pages and completions as a tar archive, as a Debian
# package where dpkg-deb is, and the checksums of both.
#
#     release/build.sh [FOLDER]        writes to FOLDER, out/release when not given
#
# Other platforms: run it there. The program needs nothing but the C library; a Windows or macOS build is
# `cargo build --profile dist` with the toolchain of that platform, and the archive is made of the same parts.
set -euo pipefail
cd "$(dirname "$0")/.."
out=$(realpath -m "${1:-out/release}")

cargo build --profile dist --quiet
program=${CARGO_TARGET_DIR:-target}/dist/stampflow
version=$("$program" --version | cut -d' ' -f2)
platform=$(rustc -vV | sed -n 's/^host: //p')
name=stampflow-$version-$platform

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=$work/$name
install -D -m 755 "$program" "$root/bin/stampflow"
# Hard links and owners as dpkg wants them; the times are those of the last commit, so that two builds are alike.
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || echo 0)}

man() { install -d "$root/share/man/man1"; "$program" man ${2:+"$2"} | gzip -9n >"$root/share/man/man1/$1.1.gz"; }
man stampflow
for verb in $("$program" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p' | grep -v help); do
    man "stampflow-$verb" "$verb"
done
completion() { install -d "$root/$2"; "$program" completions "$1" >"$root/$2/$3"; }
completion bash share/bash-completion/completions stampflow
completion zsh share/zsh/site-functions _stampflow
completion fish share/fish/vendor_completions.d stampflow.fish
for file in README.md CHANGELOG.md CITATION.cff LICENSE-MIT LICENSE-APACHE assets/*LICENSE* assets/*NOTICE*; do
    [ ! -e "$file" ] || install -D -m 644 "$file" "$root/share/doc/stampflow/$(basename "$file")"
done
cp -r cases reference_data "$root/share/doc/stampflow/"

mkdir -p "$out"
tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$SOURCE_DATE_EPOCH" -C "$work" -cf - "$name" |
    gzip -9n >"$out/$name.tar.gz"

if command -v dpkg-deb >/dev/null; then
    deb=$work/deb
    mkdir -p "$deb/DEBIAN"
    cp -r "$root" "$deb/usr"
    cat >"$deb/DEBIAN/control" <<CONTROL
Package: stampflow
Version: $version
Section: science
Priority: optional
Architecture: $(dpkg --print-architecture)
Depends: libc6
Installed-Size: $(du -sk "$deb/usr" | cut -f1)
Maintainer: The stampflow developers <stampflow@localhost>
Description: 2D sheet-metal forming by the flow approach
 Axisymmetric and plane-strain sections of stamping dies: does it tear, where,
 what does the press see, and how sure is that.
CONTROL
    dpkg-deb --root-owner-group --build "$deb" "$out/stampflow_${version}_$(dpkg --print-architecture).deb" >/dev/null
fi
(cd "$out" && sha256sum stampflow* | tee SHA256SUMS)
