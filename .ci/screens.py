"""What is printed fits a screen, and the examples of the help are understood: screens.py PROGRAM, in the project's folder."""

import pathlib
import shlex
import subprocess
import sys
import tempfile
import unicodedata

program = str(pathlib.Path(sys.argv[1]).resolve())


def printed(*words, folder="."):
    done = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True)
    return done.stdout, done.stderr


def columns(line):
    return sum(not unicodedata.combining(letter) for letter in line)


failed = []
for case in sorted(pathlib.Path("cases").glob("*.toml")):
    meaning = printed("check", str(case))[0].splitlines()
    verdict = printed("check", str(case), "--run", "--quiet")[0].splitlines()
    # A warning may take two rows of its own.
    most = [30 if "warnings" in meaning else 24, 50 if ": RED:" in verdict[0] else 40]
    rows = [len(meaning), len(verdict)]
    if rows[0] > most[0] or rows[1] > most[1] or any(columns(line) > 80 for line in meaning + verdict):
        failed.append(f"{case}: {rows} rows of at most {most}, 80 columns")
    unchecked = [line for line in verdict if line.startswith("Not checked: ")]
    if any("Press force" in line for line in unchecked) and "[press]" not in " ".join(verdict):
        failed.append(f"{case}: the key to give is missing: {unchecked}")

verbs = "new import check run report export materials sweep search scatter fit compare verify trace".split()
for verb in verbs:
    help = printed(verb, "--help")[0].replace("\n  stampflow", "\0stampflow").replace("\n\n", "\0\0").replace("\n", " ")
    examples = [part for part in help.split("\0") if part.startswith("stampflow ")]
    if len(examples) < 3:
        failed.append(f"{verb} --help has {len(examples)} examples, not 3")
    for example in examples:
        # Without its files an example fails on them; clap prints the usage where it does not know a word.
        with tempfile.TemporaryDirectory() as folder:
            error = printed(*shlex.split(example)[1:], folder=folder)[1]
        if "Usage:" in error:
            failed.append(f"{example}: {error}")
sys.exit("\n".join(failed) or 0)
