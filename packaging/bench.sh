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
#   packaging/bench.sh --performance   all of it, written as resources/help/performance.md: with a
#                                  minute of work in the window, and where the time of rows goes that
#                                  miss their goals. What was measured stays in performance/ of the
#                                  build folder
#   packaging/bench.sh --page      only the page, anew from what was measured last (after a change of
#                                  tests/benchmarks/tried.json, say)
#   packaging/bench.sh --pacing STUDY FOLDER   a minute of work in the window by a script (orbit, drill,
#                                  grow, scrub, undo): FOLDER/pacing.csv, pacing.json and
#                                  frame-pacing.png. STUDY: a path, or a case of ../shared/data
#   packaging/bench.sh --profile FILE.json [--frames …]   where the time goes, of the same groups of
#                                  figures, by the program's own trace
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
        WorkOfWholesGlTest WorkOfInvertingGlTest WorkOfGrowthGlTest WorkOfQuestionsGlTest \
        WorkOfPicturesGlTest; do
        "$burinBuild/tests/gpu_work_test" "$counted" || status=1
    done
    exit $status
fi

# The options that stand alone come first.
task=figures
case ${1-} in
    --performance | --page)
        [ $# -eq 1 ] || fail "$1 stands alone"
        task=${1#--}
        shift
        ;;
    --pacing)
        [ $# -eq 3 ] || fail "usage: packaging/bench.sh --pacing STUDY FOLDER"
        task=pacing
        study=$2
        folder=$3
        shift 3
        ;;
    --profile)
        [ $# -ge 2 ] || fail "usage: packaging/bench.sh --profile FILE.json [--frames …]"
        task=profile
        file=$2
        shift 2
        ;;
esac
for option in "$@"; do
    case $option in
        --json | --decode | --frames | --grow | --history | --load | --memory | --moving | --plane | --reactions | --refine | --sculpt | --segments) ;;
        *) fail "usage: packaging/bench.sh [--json] [--decode] [--frames] [--grow] [--history] [--load] [--memory] [--moving] [--plane] [--reactions] [--refine] [--sculpt] [--segments] | --performance | --page | --pacing STUDY FOLDER | --profile FILE.json [group…] | --smoke [--record]" ;;
    esac
done

# A folder of its own: the option would make every other build need the peers.
useBuildFolder bench
if [ "$task" != page ]; then
    {
        installPackages build run test bench
        build burin_bench burin_pacing -- -DBURIN_BENCHMARKS=ON
        startDisplay
    } >&2
fi
bench=$burinBuild/tests/benchmarks/burin_bench
pacing=$burinBuild/tests/benchmarks/burin_pacing
measured=$burinBuild/performance

# writePage: from what lies in $measured; what was not measured is left out, and the page says so.
writePage() {
    local more=()
    [ -f "$measured/figures.json" ] || fail "nothing was measured yet: packaging/bench.sh --performance"
    if [ -f "$measured/pacing.json" ]; then
        more+=(--pacing "$measured/pacing.json")
        cp "$measured/frame-pacing.png" "$burinRoot/resources/help/frame-pacing.png"
    fi
    [ ! -f "$measured/profile.json" ] || more+=(--profile "$measured/profile.json")
    python3 "$burinRoot/packaging/performance.py" "$measured/figures.json" \
        "$measured/graphics.txt" "${more[@]}" > "$measured/performance.md"
    cp "$measured/performance.md" "$burinRoot/resources/help/performance.md"
    say "wrote resources/help/performance.md" >&2
}

case $task in
    figures) "$bench" "$@" ;;
    pacing) "$pacing" "$study" "$folder" ;;
    profile) "$bench" --profile "$file" "$@" ;;
    page) writePage ;;
    performance)
        rm -rf "$measured"
        mkdir -p "$measured"
        # A figure whose results are not equal is left out; the page says that it was not measured.
        status=0
        "$bench" --json > "$measured/figures.json" || status=1
        "$burinBuild/app/burin" info --gl > "$measured/graphics.txt"
        say "a minute in the window" >&2
        "$pacing" ct_cranium_inv3 "$measured" || status=1
        say "where the time goes" >&2
        "$bench" --profile "$measured/profile.json" > /dev/null || status=1
        writePage
        exit $status
        ;;
esac
