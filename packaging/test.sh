#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests; says what each part took and which tests
# were the slowest, and ends with ctest's summary. build/check/tests.xml holds the results (JUnit).
#   packaging/test.sh            the counts of every day
#   packaging/test.sh --long     the counts that the issues name, the figures, packaging/tsan.sh and asan.sh (hours)
#   packaging/test.sh --figures  the figures and re-enactments alone
# CXX=g++ packaging/test.sh      the same, built by another compiler, in build/check-g++
set -euo pipefail
# shellcheck source=packaging/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

labels='^quick$'
groups=(build run test)
case ${1-} in
    "") ;;
    --long) labels='^(long|figures)$' groups+=(long) ;;
    --figures) labels='^figures$' ;;
    *) fail "usage: packaging/test.sh [--long | --figures]" ;;
esac

times=
# timed NAME COMMAND...: runs it and notes what it took.
timed() {
    local name=$1 began=$SECONDS status=0
    shift
    "$@" || status=$?
    times+=$(printf '%5d s  %s' $((SECONDS - began)) "$name")$'\n'
    return $status
}

# The slowest tests, and how many functions and rows Qt Test counted.
summarize() {
    say "the ten slowest tests"
    sed -n 's/.*Test *#[0-9]*: \([A-Za-z0-9_.]*\) .* \([0-9.]*\) sec.*/\2 \1/p' "$1" \
        | sort -rn | awk 'NR <= 10 { printf "%7.1f s  %s\n", $1, $2 }'
    say "functions of tests, a row of data each"
    awk '/^Totals: / { passed += $2; failed += $4; skipped += $6 }
        END { printf "  %d held, %d did not, %d were left out\n", passed, failed, skipped }' \
        "$burinBuild/Testing/Temporary/LastTest.log"
    say "what it took"
    printf '%s' "$times"
}

compiler=${CXX-}
burinPreset=check
useBuildFolder
timed "packages" installPackages "${groups[@]}"
timed "product" build burin
timed "tests" build all
timed "second compiler" build second_compiler

useTestHome
# Those that need a display start one of their own.
unset QT_SCALE_FACTOR QT_STYLE_OVERRIDE DISPLAY WAYLAND_DISPLAY XAUTHORITY

say "testing"
status=0
# One more than there are processors: some wait, for a server or a window.
timed "running" ctest --test-dir "$burinBuild" --label-regex "$labels" --output-on-failure \
    --no-tests=error --parallel $(($(buildJobs) + 1)) --output-junit "$burinBuild/tests.xml" \
    > >(tee "$burinBuild/tests.log") 2>&1 || status=$?
wait $! 2> /dev/null || true
threads=
memory=
if [ "${1-}" = --long ]; then
    threads="the threads of core are in order"
    timed "threads" env CXX="$compiler" "$burinRoot/packaging/tsan.sh" \
        || { status=1; threads="packaging/tsan.sh found fault with the threads of core"; }
    memory="memory is used in order"
    timed "memory" env CXX="$compiler" "$burinRoot/packaging/asan.sh" \
        || { status=1; memory="packaging/asan.sh found fault with the use of memory"; }
fi
summarize "$burinBuild/tests.log"
# Once more at the end, where whoever looks for the result looks first.
sed -n '/tests passed,/p' "$burinBuild/tests.log"
[ -z "$threads" ] || say "$threads; $memory"
exit $status
