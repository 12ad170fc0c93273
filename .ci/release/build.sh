#!/usr/bin/env bash
# What is shipped for this platform: the program with its manual pages, completions, cases and licences as a tar archive, as a
# Debian package where dpkg-deb is, the Python wheel beside them, and the checksums of all. `.ci/release/try.sh` tries them.
#
#     .ci/release/build.sh [--profile NAME] [FOLDER]     writes to FOLDER, out/release when not given; NAME is dist when not given
#
# Needs Rust and crates.io;
# Python 3.10 or later with venv and PyPI for the wheel.
#
# Other platforms are built there, for the program itself prints its manual pages and completions: on Linux of another
# processor by this script; for Windows by `.ci/release/windows.sh`; on macOS (not tried) by `cargo build --locked --profile dist`
# and, in bindings/python/, `maturin build --locked --release`. The program needs nothing but the C library; with `--target x86_64-unknown-linux-musl`
# (not tried) not even that.
set -euo pipefail
. "$(dirname "$0")/common.sh"

# Selected together, the program and the wheel share their dependencies.
cargo build --locked --profile "$profile" --quiet --bin stampflow -p stampflow -p stampflow-python
program=${CARGO_TARGET_DIR:-target}/$profile/stampflow
version=$("$program" --version | cut -d' ' -f2)
platform=$(rustc -vV | sed -n 's/^host: //p')
name=stampflow-$version-$platform

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=$work/$name
umask 022
# Times are those of the last commit and owners none, so that two builds are alike.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || echo 0)}
export SOURCE_DATE_EPOCH

bin=$root/bin/stampflow
mkdir -p "$root/bin"
cp "$program" "$bin"
strip "$bin"
size=$(wc -c <"$bin")
[ "$size" -le 20000000 ] || { echo "the program has $size bytes, more than 20 MB"; exit 1; }

# A page for the program and one for each verb that it names.
man=$root/share/man/man1
mkdir -p "$man"
"$program" man >"$man/stampflow.1"
for page in $(sed 's/\\-/-/g' "$man/stampflow.1" | grep -o 'stampflow-[a-z]*(1)'); do
    verb=${page#stampflow-} verb=${verb%(1)}
    [ "$verb" = help ] || "$program" man "$verb" >"$man/stampflow-$verb.1"
done
gzip -9n "$man"/*

completion() { mkdir -p "$root/$2"; "$program" completions "$1" >"$root/$2/$3"; }
completion bash share/bash-completion/completions stampflow
completion zsh share/zsh/site-functions _stampflow
completion fish share/fish/vendor_completions.d stampflow.fish
completion powershell share/stampflow stampflow.ps1

doc=$root/share/doc/stampflow
mkdir -p "$doc"
add_documents "$doc" "$platform"

rm -f "$out"/stampflow*
tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$SOURCE_DATE_EPOCH" -C "$work" -cf - "$name" |
    gzip -9n >"$out/$name.tar.gz"

if command -v dpkg-deb >/dev/null; then
    deb=$work/deb
    mkdir -p "$deb/DEBIAN" "$deb/usr"
    cp -r "$root"/* "$deb/usr"
    mv "$deb/usr/share/zsh/site-functions" "$deb/usr/share/zsh/vendor-completions"
    # Debian has the text of Apache-2.0 for all.
    { cat LICENSE-MIT; printf '\nor, at your option, Apache-2.0: /usr/share/common-licenses/Apache-2.0\n\nDejaVu Sans in the program:\n\n'
      cat assets/DejaVuSans-LICENSE.txt; } >"$deb/usr/share/doc/stampflow/copyright"
    rm "$deb"/usr/share/doc/stampflow/{LICENSE-*,DejaVuSans-LICENSE.txt}
    maintainer="The stampflow developers <stampflow@localhost>"
    printf 'stampflow (%s) unstable; urgency=medium\n\n  * What changed is in CHANGELOG.md.\n\n -- %s  %s\n' "$version" \
        "$maintainer" "$(date -uR -d "@$SOURCE_DATE_EPOCH")" | gzip -9n >"$deb/usr/share/doc/stampflow/changelog.gz"
    (cd "$deb" && find usr -type f -print0 | sort -z | xargs -0 md5sum) >"$deb/DEBIAN/md5sums"
    libc=$(objdump -T "$bin" | grep -o 'GLIBC_[0-9.]*' | sort -Vu | tail -1)
    architecture=$(dpkg --print-architecture)
    cat >"$deb/DEBIAN/control" <<CONTROL
Package: stampflow
Version: $version
Section: science
Priority: optional
Architecture: $architecture
Depends: libc6 (>= ${libc#GLIBC_}), libgcc-s1
Installed-Size: $(du -sk "$deb/usr" | cut -f1)
Maintainer: $maintainer
Description: 2D sheet-metal forming by the flow approach
 Axisymmetric and plane-strain sections of stamping dies: does it tear, where,
 what does the press see, and how sure is that.
CONTROL
    dpkg-deb --root-owner-group --build "$deb" "$out/stampflow_${version}_$architecture.deb" >/dev/null
fi

python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check "maturin<2"
"$work/venv/bin/maturin" build --locked --release --quiet --manifest-path bindings/python/Cargo.toml \
    --interpreter "$work/venv/bin/python" --out "$out"

cd "$out"
sha256sum stampflow* >SHA256SUMS
wc -c stampflow*
