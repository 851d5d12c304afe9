# shellcheck shell=bash
# What run.sh, test.sh, repeat.sh, tsan.sh, asan.sh and bench.sh share. Sourced, never run.

burinRoot=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
burinPreset=release
export LANG=C.UTF-8 LC_ALL=C.UTF-8

say() { printf '== %s\n' "$*"; }
fail() {
    printf '%s: %s\n' "$(basename "$0")" "$*" >&2
    exit 1
}

# packagesOf GROUP...: their names, one a line.
packagesOf() {
    awk -v wanted=" $* " '
        /^# group:/ { inside = index(wanted, " " $3 " ") > 0; next }
        /^#/ || NF == 0 { next }
        inside { print $1 }' "$burinRoot/packaging/packages.txt"
}

asRoot() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    elif command -v sudo > /dev/null; then
        sudo "$@"
    else
        fail "packages are missing and neither root nor sudo is at hand; as root, run: $*"
    fi
}

aptGet() {
    asRoot env DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends \
        -o DPkg::Lock::Timeout=600 -o Acquire::Retries=3 -o Dpkg::Use-Pty=0 \
        -o Dpkg::Options::=--force-confold "$@"
}

# Another apt may hold the lock of the lists, which apt itself does not wait for.
updateLists() {
    local try
    for try in 1 2 3 4 5 6; do
        aptGet update && return 0
        say "package lists: try $try failed, again in 10 s"
        sleep 10
    done
    return 1
}

# installPackages GROUP...: installs what is missing; sets packagesInstalled=yes if there was any.
packagesInstalled=no
installPackages() {
    if ! command -v dpkg-query > /dev/null; then
        say "not a Debian system: packaging/packages.txt names what must be there"
        return 0
    fi
    local names installed missing
    mapfile -t names < <(packagesOf "$@")
    # One call decides. It exits 1 when it does not know a name; that name is then missing.
    # shellcheck disable=SC2016
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${names[@]}" 2> /dev/null \
        | sed -n 's/^installed //p') || true
    mapfile -t missing < <(printf '%s\n' "${names[@]}" | grep -vxF -f <(printf '%s\n' "$installed"))
    [ ${#missing[@]} -gt 0 ] || return 0
    say "installing ${missing[*]}"
    # Tests start that server by themselves; masked, it runs neither now nor after the next boot.
    if [[ " ${missing[*]} " == *" orthanc "* ]] && command -v systemctl > /dev/null; then
        asRoot systemctl mask --quiet orthanc.service || say "orthanc cannot be masked"
    fi
    # Lists that are there usually suffice; bare or outdated ones are fetched.
    if ! { compgen -G '/var/lib/apt/lists/*_Packages*' > /dev/null \
        && aptGet install "${missing[@]}" 2> /dev/null; }; then
        updateLists || fail "apt-get update failed"
        aptGet install "${missing[@]}" || fail "could not install ${missing[*]}"
    fi
    # shellcheck disable=SC2034
    packagesInstalled=yes
}

# One job a processor, but not more than memory allows (Qt and DCMTK headers: up to 1 GB a job).
buildJobs() {
    local processors memory
    processors=$(nproc)
    memory=$(awk '/^MemAvailable/ { print int($2 / 1048576) }' /proc/meminfo)
    if [ "$memory" -lt 1 ]; then memory=1; fi
    if [ "$memory" -lt "$processors" ]; then echo "$memory"; else echo "$processors"; fi
}

# useBuildFolder [NAME]: sets $burinBuild, by the name or the preset. The compiler is clang 14, which
# builds Burin in a third of GCC's time, unless CXX says otherwise; its build has a folder of its own.
useBuildFolder() {
    burinBuild=$burinRoot/build/${1-$burinPreset}
    if [ -n "${CXX-}" ]; then
        burinBuild+=-$(basename "$CXX")
    else
        export CXX=clang++-14 CC=clang-14
    fi
}

# build TARGET... [-- CMAKE_OPTION...]: configures $burinBuild where needed and builds these targets.
build() {
    local cache=$burinBuild/CMakeCache.txt home targets=()
    while [ $# -gt 0 ] && [ "$1" != -- ]; do
        targets+=("$1")
        shift
    done
    [ $# -eq 0 ] || shift
    if [ -f "$cache" ]; then
        home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$cache")
        # CMake refuses a build folder that was copied or moved along with its tree.
        if [ "$home" != "$burinRoot" ]; then rm -rf "$burinBuild"; fi
    fi
    if [ "$packagesInstalled" = yes ] || [ ! -f "$burinBuild/build.ninja" ] \
        || [ "$burinRoot/CMakePresets.json" -nt "$cache" ]; then
        say "configuring"
        mkdir -p "$burinBuild"
        (cd "$burinRoot" && cmake --preset "$burinPreset" -B "$burinBuild" "$@") \
            > "$burinBuild/configure.log" 2>&1 \
            || { cat "$burinBuild/configure.log" >&2; fail "cmake could not configure"; }
    fi
    say "building"
    runBuild "${targets[@]}" && return
    # A package that was updated since makes precompiled headers useless; Ninja does not see it, as
    # the headers in packages are older than what was compiled from them.
    local stale
    stale=$(find "$burinBuild" -name '*.pch' ! -newer /var/lib/dpkg/status 2> /dev/null)
    [ -n "$stale" ] || fail "the build failed"
    say "packages have changed: building again from the headers on"
    find "$burinBuild" -name '*.pch' -delete
    runBuild "${targets[@]}" || fail "the build failed"
}

runBuild() { cmake --build "$burinBuild" --parallel "$(buildJobs)" --target "$@"; }

# Tests see neither the user's settings nor leave anything in the home folder; what they cache
# (Mesa's compiled shaders) is shared by all of them, and stays for the next run.
useTestHome() {
    local home=$burinBuild/test-home
    mkdir -p "$home"/{config,data,state,cache,runtime}
    chmod 700 "$home/runtime"
    export XDG_CONFIG_HOME=$home/config XDG_DATA_HOME=$home/data XDG_STATE_HOME=$home/state \
        XDG_CACHE_HOME=$home/cache XDG_RUNTIME_DIR=$home/runtime
}

# A private X server for programs that need a window; ends with the script.
# Without -noreset it begins anew whenever its last client leaves, and turns away who comes meanwhile.
startDisplay() {
    local number descriptor folder
    folder=$(mktemp -d)
    mkfifo "$folder/display"
    Xvfb -displayfd 3 -screen 0 2560x1440x24 -nolisten tcp -noreset \
        3> "$folder/display" 2> "$folder/log" &
    displayServer=$!
    trap 'kill "$displayServer" 2> /dev/null || true' EXIT
    exec {descriptor}< "$folder/display"
    read -r -t 30 number <&"$descriptor" || { cat "$folder/log" >&2; fail "Xvfb did not start"; }
    exec {descriptor}<&-
    rm -rf "$folder"
    export DISPLAY=:$number QT_QPA_PLATFORM=xcb
    if [ -z "${XDG_RUNTIME_DIR-}" ]; then
        export XDG_RUNTIME_DIR=$burinBuild/runtime
        mkdir -p "$XDG_RUNTIME_DIR"
        chmod 700 "$XDG_RUNTIME_DIR"
    fi
    unset WAYLAND_DISPLAY XAUTHORITY
}
