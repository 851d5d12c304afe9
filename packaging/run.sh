#!/usr/bin/env bash
# Installs what is missing, builds, and opens the workstation.
#   packaging/run.sh                            the built-in demonstration study
#   packaging/run.sh STUDY                      a folder of DICOM files, or a NIfTI, NRRD or MetaImage file
#   packaging/run.sh [STUDY] --screenshot FILE  saves the refined window as PNG; needs no display
#   packaging/run.sh [STUDY] --size WxH         size of the window
set -euo pipefail
# shellcheck source=packaging/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage="usage: packaging/run.sh [STUDY] [--screenshot FILE] [--size WxH]"
study=
screenshot=
options=()
while [ $# -gt 0 ]; do
    case $1 in
        --help | -h) echo "$usage"; exit 0 ;;
        --screenshot | --size)
            [ $# -gt 1 ] || fail "$1 needs a value; $usage"
            if [ "$1" = --screenshot ]; then screenshot=$2; fi
            options+=("$1" "$2")
            shift 2
            ;;
        -*) fail "unknown option $1; $usage" ;;
        *)
            [ -z "$study" ] || fail "one study at a time; $usage"
            study=$1
            [ -e "$study" ] || fail "there is no $study"
            shift
            ;;
    esac
done

if [ -z "$screenshot" ] && [ -z "${DISPLAY-}${WAYLAND_DISPLAY-}" ]; then
    fail "there is no display to open a window on (DISPLAY is not set).
  Run it in a desktop session, or over 'ssh -X', or with a virtual display and a VNC server;
  or save a picture of the window instead: packaging/run.sh --screenshot window.png"
fi

useBuildFolder
installPackages build run
build burin
burin=$burinBuild/app/burin

# Made on its first opening and kept in the user's cache.
if [ -z "$study" ]; then study=--demo; fi

if [ -n "$screenshot" ]; then
    startDisplay
    "$burin" open "$study" "${options[@]}"
    say "saved $screenshot"
else
    exec "$burin" open "$study" "${options[@]}"
fi
