#!/usr/bin/env bash
# secondCompiler.sh STAMP COMPILER ARGUMENTS HEADERS SOURCE...
# Has COMPILER read the sources, with the arguments in the file ARGUMENTS: all as one, behind the
# headers of others, which is quick. A source that cannot stand with those before it (two helpers of
# one name) is put apart, so that only what a source does wrong by itself fails. Writes STAMP and
# what it depends on, STAMP.d.
set -euo pipefail
stamp=$1 compiler=$2 arguments=$3 headers=$4
shift 4
: > "$stamp.d"

# readTogether SOURCE...: whether they compile as one.
readTogether() {
    local part=$stamp.part
    printf '#include "%s"\n' "$@" > "$part.cpp"
    "$compiler" "@$arguments" -fsyntax-only -include "$headers" -MD -MF "$part.d" -MQ "$stamp" \
        "$part.cpp" > "$part.log" 2>&1 || return 1
    cat "$part.d" >> "$stamp.d"
}

readAll() {
    local together=("$@") apart=() first source rest
    until readTogether "${together[@]}"; do
        if [ ${#together[@]} = 1 ]; then
            cat "$stamp.part.log"
            return 1
        fi
        # The source that the first error names; the last one where that is in a header.
        first=$(sed -n 's/^\([^ :]*\):[0-9:]* \(fatal \)\?error: .*/\1/p' "$stamp.part.log" | sed -n 1p)
        rest=()
        for source in "${together[@]}"; do
            [ "$source" = "$first" ] || rest+=("$source")
        done
        if [ ${#rest[@]} = ${#together[@]} ]; then
            first=${together[-1]}
            rest=("${together[@]:0:${#together[@]}-1}")
        fi
        together=("${rest[@]}")
        apart+=("$first")
    done
    [ ${#apart[@]} = 0 ] || readAll "${apart[@]}"
}

readAll "$@"
rm -f "$stamp".part.*
touch "$stamp"
