# What the scripts that build for a platform share; they source it. Their options, `[--profile NAME] [FOLDER]`: sets `profile`, dist
# when not given, and `out`, made if it is not there, out/release when not given.
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
profile=dist
if [ "${1:-}" = --profile ]; then profile=$2; shift 2; fi
mkdir -p "${1:-out/release}"
out=$(cd "${1:-out/release}" && pwd)

# FOLDER TARGET: what goes beside the program.
add_documents() {
    cp -r README.md CHANGELOG.md CITATION.cff LICENSE-MIT LICENSE-APACHE assets/DejaVuSans-LICENSE.txt cases reference_data "$1"
    .ci/release/licences.sh "$2" >"$1/LICENSES-crates.txt"
}
