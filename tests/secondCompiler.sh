#!/usr/bin/env bash
# secondCompiler.sh STAMP COMPILER ARGUMENTS SOURCE...
# Has COMPILER read the sources, with the arguments in the file ARGUMENTS: all as one, which is
# quick. Sources that cannot stand together (two helpers of one name) are halved until they can, so
# that only what a source does wrong by itself fails. Writes STAMP and what it depends on, STAMP.d.
set -euo pipefail
stamp=$1 compiler=$2 arguments=$3
shift 3
: > "$stamp.d"

# readTogether SOURCE...: whether they compile as one.
readTogether() {
    local part=$stamp.part
    printf '#include "%s"\n' "$@" > "$part.cpp"
    "$compiler" "@$arguments" -MD -MF "$part.d" -MQ "$stamp" "$part.cpp" > "$part.log" 2>&1 || return 1
    cat "$part.d" >> "$stamp.d"
}

readAll() {
    readTogether "$@" && return
    if [ $# = 1 ]; then
        cat "$stamp.part.log"
        return 1
    fi
    local half=$(($# / 2))
    readAll "${@:1:half}"
    readAll "${@:half+1}"
}

readAll "$@"
rm -f "$stamp".part.*
touch "$stamp"
