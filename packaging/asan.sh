#!/usr/bin/env bash
# Builds everything with clang's sanitizers of addresses and of undefined behaviour and runs the tests
# under them, with the counts of every day (an hour and a half on two processors, besides the build):
# memory that is used after its end or past its bounds, and arithmetic that has no result, is a test
# that failed. packaging/test.sh --long ends with it and with tsan.sh.
#   packaging/asan.sh             all of them
#   packaging/asan.sh REGEX       those whose names match
#
# What is not run here:
# - LibraryMemoryTest, MemoryFailureGlTest, RefusedNewGlTest and those that count what work costs
#   (WorkOf…GlTest): they put an allocation of their own in the place of the sanitizer's;
# - single functions in which a process may have only little memory, or throws behind the fence that
#   lets it read no file: those tests say so themselves;
# - a search for memory that nobody freed: drivers and Qt keep theirs (DrivenWindowUiTest counts).
set -euo pipefail
# shellcheck source=packaging/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
[ $# -le 1 ] || fail "usage: packaging/asan.sh [REGEX]"

# Always clang, whose sanitizers stand in the program itself: what is preloaded comes before others.
unset CXX CC
installPackages build run test
burinPreset=asan
useBuildFolder
build all
useTestHome
unset QT_SCALE_FACTOR QT_STYLE_OVERRIDE DISPLAY WAYLAND_DISPLAY XAUTHORITY

ASAN_SYMBOLIZER_PATH=$(command -v llvm-symbolizer-14) || fail "llvm-symbolizer-14 is missing"
export ASAN_SYMBOLIZER_PATH
export ASAN_OPTIONS="detect_leaks=0:exitcode=86"
export UBSAN_OPTIONS="halt_on_error=1:print_stacktrace=1:exitcode=87"
UBSAN_OPTIONS+=":suppressions=$burinRoot/packaging/asan.supp"

say "testing"
status=0
ctest --test-dir "$burinBuild" --label-regex '^quick$' \
    --exclude-regex '^(LibraryMemoryTest|MemoryFailureGlTest|RefusedNewGlTest|WorkOf.*GlTest)$' ${1:+--tests-regex "$1"} \
    --output-on-failure --no-tests=error --parallel $(($(buildJobs) + 1)) \
    --output-junit "$burinBuild/tests.xml" 2>&1 | tee "$burinBuild/tests.log" || status=$?
exit $status
