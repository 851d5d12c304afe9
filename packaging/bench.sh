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
#   packaging/bench.sh --memory    what a session with 20 segments takes
#   packaging/bench.sh --moving    pictures while the camera moves, and after letting go
#   packaging/bench.sh --plane     a cutting plane with a contour only, against VTK's filters
#   packaging/bench.sh --reactions from a step of the hand to its picture: drilling, growing, undo, chunks,
#                                  margins and smoothing of large segments
#   packaging/bench.sh --refine    the surface of a segment while it is repaired, and chunks
#   packaging/bench.sh --sculpt    masks and strokes of the sculpting tools only
#   packaging/bench.sh --segments  what works on a whole segment, on three real series, against ITK's filters
#   packaging/bench.sh --performance   all of it, written as resources/help/performance.md
#   packaging/bench.sh --smoke     no times: what steps of the hand and their pictures cost in what is
#                                  counted (bricks, dispatches, pixels, bytes, large allocations) against
#                                  what is recorded in tests/data/work, as the daily tests do
#   packaging/bench.sh --smoke --record   records it anew
# BURIN_BENCH_PICTURES=FOLDER keeps the compared pictures.
set -euo pipefail
# shellcheck source=packaging/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

if [ "$*" = --smoke ] || [ "$*" = "--smoke --record" ]; then
    {
        useBuildFolder
        installPackages build run test
        build gpu_work_test
    } >&2
    unset BURIN_RECORD_WORK
    [ "$*" = --smoke ] || export BURIN_RECORD_WORK=1
    status=0
    for counted in WorkOfStepsGlTest WorkOfLabelsGlTest WorkOfPartsGlTest WorkOfShapesGlTest \
        WorkOfPicturesGlTest; do
        "$burinBuild/tests/gpu_work_test" "$counted" || status=1
    done
    exit $status
fi

performance=no
for option in "$@"; do
    case $option in
        --performance)
            [ $# -eq 1 ] || fail "--performance stands alone"
            performance=yes
            ;;
        --json | --decode | --frames | --grow | --history | --load | --memory | --moving | --plane | --reactions | --refine | --sculpt | --segments) ;;
        *) fail "usage: packaging/bench.sh [--json] [--decode] [--frames] [--grow] [--history] [--load] [--memory] [--moving] [--plane] [--reactions] [--refine] [--sculpt] [--segments] | --performance | --smoke [--record]" ;;
    esac
done

{
    # A folder of its own: the option would make every other build need the peers.
    useBuildFolder bench
    installPackages build run test bench
    build burin_bench -- -DBURIN_BENCHMARKS=ON
    startDisplay
} >&2
bench=$burinBuild/tests/benchmarks/burin_bench
if [ "$performance" = no ]; then
    "$bench" "$@"
else
    folder=$(mktemp -d)
    # What is not right is not among them; the page says that it was not measured.
    status=0
    "$bench" --json > "$folder/figures.json" || status=1
    "$burinBuild/app/burin" info --gl > "$folder/graphics.txt"
    python3 "$burinRoot/packaging/performance.py" "$folder/figures.json" "$folder/graphics.txt" \
        > "$folder/performance.md"
    mv "$folder/performance.md" "$burinRoot/resources/help/performance.md"
    rm -rf "$folder"
    say "wrote resources/help/performance.md" >&2
    exit $status
fi
