#!/usr/bin/env bash
# A sweep in 64 shards on a real HyperQueue, one of whose two workers is killed in the middle: byte for byte the table of one
# process. Call: hyperqueue.sh STAMPFLOW PYTHON, with a Python that has the package hyperqueue. Everything stays on this
# machine, in a folder that goes at the end, and ends by itself.
set -euo pipefail
stampflow=$(realpath "$1") python=$(realpath -s "$2") here=$(realpath "$(dirname "$0")")
quickstart=$(realpath "$here/../../cases/quickstart.toml")
work=$(mktemp -d) pids=()
trap 'kill -9 "${pids[@]}" 2>/dev/null || true; wait 2>/dev/null || true; rm -rf "$work"' EXIT
fail() { echo "hyperqueue: $*"; tail -n 5 "$work"/*.log; exit 1; }
cd "$work"

# As a user has them on the PATH; what is run is written down, once for every time that a shard is begun.
mkdir bin
printf '#!/bin/sh\nexec "%s" "%s" "$@"\n' "$python" "$here/hq" > bin/hq
printf '#!/bin/sh\n[ -z "$HQ_TASK_ID" ] || echo "$HQ_TASK_ID" >> "%s"\nexec "%s" "$@"\n' "$work/begun" "$stampflow" > bin/stampflow
chmod +x bin/*
export PATH="$work/bin:$PATH" HQ_SERVER_DIR="$work/server"

cat > study.toml <<STUDY
case = "$quickstart"
set = ["blank.elements=30"]
[vary]
friction = "0.04..0.12/32"
tools.holder.force = "5..30 kN/8"
STUDY
stampflow sweep study.toml --out one --quiet > one.log

await() { # at most 20 s
    for _ in $(seq 200); do "$@" && return; sleep 0.1; done
    fail "waited too long: $*"
}
mkdir server
hq server start --server-dir server > server.log 2>&1 & pids+=($!)
await test -e server/ready
start_worker() {
    hq worker start --server-dir server --cpus 1 > "worker-$1.log" 2>&1 & pids+=($!)
    await test -e "server/of-worker-$!/ready"
    worker=$!
}
start_worker 1
killed=$worker
start_worker 2

# The lines as the book has them.
sed -n '/^hq submit/,/[^\\]$/p; /^stampflow merge/p' "$here/../../docs/studies.md" > lines
[ "$(grep -c . lines)" -eq 3 ] || fail "the book's lines are others"
timeout 90 bash -euo pipefail lines > lines.log 2>&1 & lines=$!

# In the middle: some shards are whole, and this worker is at another.
some_are_whole() { [ "$(find shards -name 'study-*.csv' 2>/dev/null | wc -l)" -ge 8 ]; }
is_at_work() { pgrep -P "$killed" > child; }
await some_are_whole
await is_at_work
kill -9 "$killed"
wait "$killed" 2>/dev/null || true
start_worker 3
wait "$lines" || fail "the lines ended with an error"

cmp one/study.csv shards/study.csv || fail "the tables differ"
again=$(sort begun | uniq -d | wc -l)
[ "$again" -ge 1 ] || fail "no shard was begun again: the kill hit nothing"
[ "$(sort -u begun | wc -l)" -eq 64 ] || fail "not every shard was begun"
echo "hyperqueue: 64 shards, $(($(wc -l < one/study.csv) - 1)) designs, a worker killed, $again shard(s) begun again: the same bytes"
