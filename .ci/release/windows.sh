#!/usr/bin/env bash
# The program for Windows as a zip: stampflow.exe with its cases, licences and the printed book. `.ci/windows` tries it.
#
#     .ci/release/windows.sh [--profile NAME] [FOLDER]   writes to FOLDER, out/release when not given; NAME is dist when not given
#
# Needs Rust with rustup, crates.io, Debian's gcc-mingw-w64-x86-64-win32 and zip, which are installed when they are not there, and
# what `.ci/book` needs. The book is printed by chromium; without it the zip holds the pages for a browser.
set -euo pipefail
. "$(dirname "$0")/common.sh"
target=x86_64-pc-windows-gnu

rustup target list --installed | grep -qx "$target" || rustup target add "$target"
command -v x86_64-w64-mingw32-gcc >/dev/null && command -v zip >/dev/null ||
    { apt-get update && apt-get install -y gcc-mingw-w64-x86-64-win32 zip; } >/dev/null
cargo build --locked --profile "$profile" --quiet --bin stampflow --target "$target"
version=$(cargo pkgid | sed 's/.*[#@]//')
name=stampflow-$version-windows

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=$work/$name
mkdir "$root"
cp "${CARGO_TARGET_DIR:-target}/$target/$profile/stampflow.exe" "$root"
x86_64-w64-mingw32-strip "$root/stampflow.exe"
# Whatever else it needs would have to be in the zip.
dlls=$(x86_64-w64-mingw32-objdump -p "$root/stampflow.exe" | sed -n 's/.*DLL Name: //p' | sort -fu)
if grep -iE '^lib|mingw|pthread' <<<"$dlls"; then echo "the program needs these libraries, which Windows has not"; exit 1; fi
add_documents "$root" "$target"

.ci/book
browser=$(command -v chromium chromium-browser google-chrome | head -1 || true)
if [ -n "$browser" ]; then
    timeout 300 "$browser" --headless --no-sandbox --disable-gpu --no-pdf-header-footer \
        --print-to-pdf="$root/stampflow.pdf" "file://$PWD/book/print.html" 2>/dev/null
    [ -s "$root/stampflow.pdf" ] || { echo "the book was not printed"; exit 1; }
else
    echo "the book is not printed: chromium is not here"
    cp -r book "$root/book"
fi

rm -f "$out/$name.zip"
(cd "$work" && zip -9 -X -q -r "$out/$name.zip" "$name")
size=$(wc -c <"$out/$name.zip")
[ "$size" -le 15000000 ] || { echo "the zip has $size bytes, more than 15 MB"; exit 1; }
echo "$out/$name.zip: $size bytes, the program $(wc -c <"$root/stampflow.exe"); of Windows: $(paste -sd ' ' <<<"$dlls")"
