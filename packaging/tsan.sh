#!/usr/bin/env bash
# Builds core and its tests with clang's thread sanitizer and runs them, with the counts of every day
# and the oracle for an engine (more than an hour on two processors, besides the build): a race of two
# threads, or locks taken in two orders, is a test that failed. packaging/test.sh --long ends with it.
#   packaging/tsan.sh             all of them
#   packaging/tsan.sh REGEX       those whose names match
#
# What is not run here:
# - whatever needs GL or a window: drivers and Qt's windows are built without the sanitizer, which
#   then knows nothing of what orders their threads;
# - DICOMweb: Qt speaks it on a thread of its own (QNetworkAccessManager), to which it hands all it has;
# - whatever must get no memory, or no thread: those tests say so themselves;
# - the program burin: tests start the one that test.sh builds, and decode in its processes, whose
#   fence leaves no room for the terabytes of addresses that the sanitizer takes for itself.
set -euo pipefail
# shellcheck source=packaging/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
[ $# -le 1 ] || fail "usage: packaging/tsan.sh [REGEX]"

# Always clang: GCC's sanitizer refuses fences of memory.
unset CXX CC
installPackages build run test
burinPreset=check
useBuildFolder
build burin
unset CXX CC
burinPreset=tsan
useBuildFolder
build core_tests burin_planted_race
useTestHome

# All that a test does wrong is told, not the first alone. What is not told goes by names of functions.
symbolizer=$(command -v llvm-symbolizer-14) || fail "llvm-symbolizer-14 is missing"
export TSAN_OPTIONS="halt_on_error=0:exitcode=66:history_size=4:second_deadlock_stack=1"
TSAN_OPTIONS+=":suppressions=$burinRoot/packaging/tsan.supp"
TSAN_OPTIONS+=":external_symbolizer_path=$symbolizer"
# Qt Test by itself ends a function after five minutes; all of it is slower here.
export QTEST_FUNCTION_TIMEOUT=14400000

say "is a planted race told?"
if "$burinBuild/tests/burin_planted_race" > "$burinBuild/planted.log" 2>&1 \
    || ! grep -q "WARNING: ThreadSanitizer: data race" "$burinBuild/planted.log"; then
    cat "$burinBuild/planted.log" >&2
    fail "the sanitizer says nothing of a race that is there"
fi

say "testing"
status=0
ctest --test-dir "$burinBuild" --label-regex '^core$' --exclude-regex '^(DicomWeb|RudeWeb|WebConnection)' \
    ${1:+--tests-regex "$1"} --output-on-failure --no-tests=error \
    --parallel "$(buildJobs)" --output-junit "$burinBuild/tests.xml" \
    2>&1 | tee "$burinBuild/tests.log" || status=$?
exit $status
