#!/usr/bin/env bash
# Times Burin against ITK and VTK on the demonstration head, in one run, after checking that the
# results are equal.
#   packaging/bench.sh          a table
#   packaging/bench.sh --json   [{"id","peer","oursMs","peerMs","ratio"}], ratio = peer / ours
# BURIN_BENCH_PICTURES=FOLDER keeps the compared pictures.
set -euo pipefail
# shellcheck source=packaging/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case ${1-} in
    "" | --json) ;;
    *) fail "usage: packaging/bench.sh [--json]" ;;
esac

{
    installPackages build run test bench
    # A folder of its own: the option would make every other build need the peers.
    burinBuild=$burinRoot/build/bench
    build burin_bench -- -DBURIN_BENCHMARKS=ON
    startDisplay
} >&2
"$burinBuild/tests/benchmarks/burin_bench" "$@"
