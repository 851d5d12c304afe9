#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test; ends with ctest's summary.
#   packaging/test.sh          the counts of every day
#   packaging/test.sh --long   the counts that the issues name (hours)
set -euo pipefail
# shellcheck source=packaging/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

label=quick
case ${1-} in
    "") ;;
    --long) label=long ;;
    *) fail "usage: packaging/test.sh [--long]" ;;
esac

installPackages build run test
build all clang_syntax

# Tests see neither the user's settings nor leave anything in the home folder; what they cache
# (Mesa's compiled shaders) stays for the next run.
home=$burinBuild/test-home
mkdir -p "$home"/{config,data,state,cache,runtime}
chmod 700 "$home/runtime"
export XDG_CONFIG_HOME=$home/config XDG_DATA_HOME=$home/data XDG_STATE_HOME=$home/state \
    XDG_CACHE_HOME=$home/cache XDG_RUNTIME_DIR=$home/runtime
unset QT_SCALE_FACTOR QT_STYLE_OVERRIDE

startDisplay
say "testing"
ctest --test-dir "$burinBuild" --label-regex "^$label\$" --output-on-failure --no-tests=error \
    --parallel "$(buildJobs)"
