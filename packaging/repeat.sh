#!/usr/bin/env bash
# Runs tests again and again, several at a time and beside programs that only compute: what goes
# wrong once in a hundred runs (two threads, memory that is given back twice as a window closes) does
# so here, and is counted. Only tests of every day are run, and they do no more than they do then.
#   packaging/repeat.sh REGEX            each class whose name matches, 100 times
#   packaging/repeat.sh --times N REGEX  N times
#   packaging/repeat.sh --at-once K …    K of them at a time (otherwise two a processor)
#   packaging/repeat.sh --load L …       beside L programs that only compute (otherwise one a processor)
#                                        unless there is one run of each, which has nothing beside it
#   packaging/repeat.sh --memcheck …     under valgrind: memory that is used after its end, past its
#                                        bounds or before it has a value is a run that failed. Runs are
#                                        some thirty times as slow; without --times there is one of each
# For all windows: packaging/repeat.sh 'UiTest$'. What a run said that failed stays in
# build/check/repeated, as CLASS.NUMBER.log. The status is 1 if any failed.
#
# Each run has folders of its own for settings, caches and sessions, so that a class may run beside
# itself; compiled shaders are shared.
set -euo pipefail
# shellcheck source=packaging/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage="usage: packaging/repeat.sh [--times N] [--at-once K] [--load L] [--memcheck] REGEX"
times=
atOnce=$((2 * $(nproc)))
load=$(nproc)
memcheck=no
regex=
while [ $# -gt 0 ]; do
    case $1 in
        --help | -h) echo "$usage"; exit 0 ;;
        --times | --at-once | --load)
            [[ ${2-} =~ ^[0-9]+$ ]] || fail "$1 needs a number; $usage"
            case $1 in
                --times) times=$2 ;;
                --at-once) atOnce=$2 ;;
                --load) load=$2 ;;
            esac
            shift 2
            ;;
        --memcheck) memcheck=yes; shift ;;
        -*) fail "unknown option $1; $usage" ;;
        *)
            [ -z "$regex" ] || fail "one expression at a time; $usage"
            regex=$1
            shift
            ;;
    esac
done
[ -n "$regex" ] || fail "$usage"
[ "$atOnce" -gt 0 ] || fail "at least one at a time; $usage"
if [ -z "$times" ]; then
    if [ "$memcheck" = yes ]; then times=1; else times=100; fi
fi

groups=(build run test)
if [ "$memcheck" = yes ]; then groups+=(memcheck); fi
installPackages "${groups[@]}"
burinPreset=check
useBuildFolder
build all
unset QT_SCALE_FACTOR QT_STYLE_OVERRIDE DISPLAY WAYLAND_DISPLAY XAUTHORITY

repeated=$burinBuild/repeated
rm -rf "$repeated"
mkdir -p "$repeated/classes"
export repeated memcheck burinRoot

# A file for each class, as ctest would run it: seconds, folder, "NAME=VALUE" of its environment, an
# empty line, the words of its command.
ctest --test-dir "$burinBuild" --label-regex '^quick$' --tests-regex "$regex" --show-only=json-v1 \
    | python3 -c '
import json, sys
for test in json.load(sys.stdin)["tests"]:
    said = {each["name"]: each["value"] for each in test.get("properties", [])}
    lines = [str(int(said.get("TIMEOUT", 1800))), said.get("WORKING_DIRECTORY", ".")]
    lines += said.get("ENVIRONMENT", []) + [""] + test["command"]
    with open(sys.argv[1] + "/" + test["name"], "w") as file:
        file.write("\n".join(lines) + "\n")
' "$repeated/classes"
mapfile -t classes < <(ls "$repeated/classes")
[ ${#classes[@]} -gt 0 ] || fail "no test of every day matches $regex"

# runOnce CLASS NUMBER: its output stays where it failed.
runOnce() {
    local name=$1 number=$2 log home status=0 lines=() environment=() words=() watch=() seconds i
    mapfile -t lines < "$repeated/classes/$name"
    seconds=${lines[0]}
    for ((i = 2; i < ${#lines[@]}; ++i)); do
        [ -n "${lines[i]}" ] || break
        environment+=("${lines[i]}")
    done
    words=("${lines[@]:i + 1}")
    home=$(mktemp -d)
    mkdir -p "$home"/{config,data,state,cache,runtime}
    chmod 700 "$home/runtime"
    environment+=(XDG_CONFIG_HOME="$home/config" XDG_DATA_HOME="$home/data"
        XDG_STATE_HOME="$home/state" XDG_CACHE_HOME="$home/cache" XDG_RUNTIME_DIR="$home/runtime")
    if [ "$memcheck" = yes ]; then
        seconds=$((seconds * 8))
        environment+=(QTEST_FUNCTION_TIMEOUT="${seconds}000")
        # Those that a test starts are not watched: decoders, servers, the program itself.
        watch=(valgrind --quiet --error-exitcode=86 --num-callers=40 --child-silent-after-fork=yes
            --suppressions="$burinRoot/packaging/memcheck.supp")
    fi
    log=$repeated/$name.$number.log
    (cd "${lines[1]}" && exec env "${environment[@]}" timeout --kill-after=30 "$seconds" \
        "${watch[@]}" "${words[@]}") > "$log" 2>&1 || status=$?
    rm -rf "$home"
    if [ "$status" = 0 ]; then
        rm -f "$log"
        return 0
    fi
    echo "$name" >> "$repeated/failed"
    echo "$name, run $number: status $status; ${log#"$burinRoot/"}"
}
export -f runOnce

computing=()
# shellcheck disable=SC2317
endLoad() { [ ${#computing[@]} -eq 0 ] || kill "${computing[@]}" 2> /dev/null || true; }
trap endLoad EXIT
for ((i = 0; i < load && times > 1; ++i)); do
    (while :; do :; done) &
    computing+=($!)
done

say "${#classes[@]} classes, each $times times, $atOnce at a time beside ${#computing[@]} that only compute"
: > "$repeated/failed"
# All of them once, then all of them again: what fails often is seen soon.
for ((number = 1; number <= times; ++number)); do
    for name in "${classes[@]}"; do printf '%s\n%s\n' "$name" "$number"; done
done | xargs -d '\n' -n 2 -P "$atOnce" bash -c 'runOnce "$@"' runOnce
say "how often each failed"
for name in "${classes[@]}"; do
    printf '%6d of %d  %s\n' "$(grep -cxF "$name" "$repeated/failed" || true)" "$times" "$name"
done | sort -rn
[ ! -s "$repeated/failed" ]
