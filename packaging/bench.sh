#!/usr/bin/env bash
# Measures Burin against ITK and VTK on the demonstration head, and its history against whole-image
# undo on 512 x 512 x 600 voxels (3 GB of memory), in one run, after checking that the results are
# equal.
#   packaging/bench.sh             a table
#   packaging/bench.sh --json      [{"id","peer","oursMs","peerMs","ratio"}], ratio = peer / ours;
#                                  "oursBytes", "peerBytes" for sizes; without a peer only ours
#   packaging/bench.sh --decode    compressed frames in processes without rights, against in the program
#   packaging/bench.sh --frames    pictures, and growing on the demonstration head
#   packaging/bench.sh --grow      growing only
#   packaging/bench.sh --history   the history only
#   packaging/bench.sh --load      a series of 450 slices, against ITK with GDCM and dcm2niix, and in the window
#   packaging/bench.sh --moving    pictures while the camera moves, and after letting go
#   packaging/bench.sh --plane     a cutting plane with a contour only, against VTK's filters
#   packaging/bench.sh --refine    the surface of a segment while it is repaired, and chunks
#   packaging/bench.sh --sculpt    masks and strokes of the sculpting tools only
# BURIN_BENCH_PICTURES=FOLDER keeps the compared pictures.
set -euo pipefail
# shellcheck source=packaging/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

for option in "$@"; do
    case $option in
        --json | --decode | --frames | --grow | --history | --load | --moving | --plane | --refine | --sculpt) ;;
        *) fail "usage: packaging/bench.sh [--json] [--decode] [--frames] [--grow] [--history] [--load] [--moving] [--plane] [--refine] [--sculpt]" ;;
    esac
done

{
    # A folder of its own: the option would make every other build need the peers.
    useBuildFolder bench
    installPackages build run test bench
    build burin_bench -- -DBURIN_BENCHMARKS=ON
    startDisplay
} >&2
"$burinBuild/tests/benchmarks/burin_bench" "$@"
