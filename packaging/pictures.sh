#!/usr/bin/env bash
# Draws the pictures of the manual anew: builds and runs the tests that draw them, and puts those that
# the manual shows into resources/help. What else these tests draw is thrown away.
#   packaging/pictures.sh             all of them
#   packaging/pictures.sh REGEX       those of the tests whose names match
# A page that shows a picture which is not there yet gets it, too. Some tests read studies in ../shared
# and draw nothing where these are missing. The script says what was drawn, and at the end of a whole
# run which pictures of the manual no test draws.
set -euo pipefail
# shellcheck source=packaging/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
[ $# -le 1 ] || fail "usage: packaging/pictures.sh [REGEX]"

# A program and its tests a line. Where two tests draw a picture, that of the first one stays.
drawers="
app_figures_test ManualPicturesUiTest SegmentPicturesUiTest SlicePicturesUiTest ToolPicturesUiTest
app_figures_test GrowthFiguresGlTest OrganFiguresGlTest ReenactmentGlTest RefinementFiguresUiTest RefinementTableFiguresGlTest
app_window_test AuditUiTest
ui_frame_test SessionOffersUiTest
ui_pacs_test PacsBrowserUiTest
gpu_render_test RadiatedCutGlTest RadiatedSegmentGlTest
"
programs=()
tests=()
while read -r program names; do
    for name in $names; do
        if [[ $name =~ ${1-} ]]; then
            programs+=("$program")
            tests+=("$name")
        fi
    done
done <<< "$drawers"
[ ${#tests[@]} -gt 0 ] || fail "no test that draws has a name like $1"

installPackages build run test
burinPreset=check
useBuildFolder
mapfile -t programs < <(printf '%s\n' "${programs[@]}" | sort -u)
build burin "${programs[@]}"
useTestHome
unset QT_SCALE_FACTOR QT_STYLE_OVERRIDE DISPLAY WAYLAND_DISPLAY XAUTHORITY

manual=$burinRoot/resources/help
# The pictures that lie there, and those that a page shows.
wanted=$(
    cd "$manual"
    { printf '%s\n' *.png; grep -oh '([a-z0-9-]*\.png)' -- *.md | tr -d '()'; } | sort -u
)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
status=0
for name in "${tests[@]}"; do
    say "$name"
    mkdir "$folder/$name"
    BURIN_SCREENSHOTS=$folder/$name ctest --test-dir "$burinBuild" --tests-regex "^$name\$" \
        --output-on-failure --no-tests=error > "$folder/log" 2>&1 \
        || { status=1; cat "$folder/log" >&2; continue; }
    for picture in "$folder/$name"/*.png; do
        file=$(basename "$picture")
        if grep -qxF -- "$file" <<< "$wanted" && ! grep -qxF "$file" "$folder/drawn" 2> /dev/null; then
            cp "$picture" "$manual/$file"
            echo "$file" >> "$folder/drawn"
            say "drew $file"
        fi
    done
done
if [ $# -eq 0 ]; then
    for file in $wanted; do
        # One picture is drawn by packaging/bench.sh from what it measures.
        grep -qxF "$file" "$folder/drawn" 2> /dev/null \
            || grep -qF "/$file" "$burinRoot/packaging/bench.sh" \
            || say "nobody drew $file"
    done
fi
exit $status
