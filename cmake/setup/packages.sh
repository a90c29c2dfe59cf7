# What ./run and ./test install. Sourced by them; POSIX sh. Package names are the same on Debian 12 and newer
# and on Ubuntu 24.04.

build_packages="g++ cmake ninja-build qt6-base-dev qt6-serialport-dev qt6-svg-dev libqcustomplot-dev libeigen3-dev
    nlohmann-json3-dev libpugixml-dev libsqlite3-dev zlib1g-dev
    qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools
    libgl-dev qt6-qpa-plugins fonts-dejavu-core"
test_packages="libgtest-dev xvfb" # xvfb: the window on a display of its own
# Beyond ./test, for .ci/run: sanitizers and fuzzing need clang 19.
ci_packages="ccache clang-19 clang-tidy-19 clang-format-19 libclang-rt-19-dev"

say() { printf '%s\n' "$*" >&2; }

# install_missing PACKAGE...: installs those that are not there, saying which; nothing when all are there.
install_missing() {
    missing=""
    for package in "$@"; do
        case "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" in
        installed) ;;
        *) missing="$missing $package" ;;
        esac
    done
    [ -z "$missing" ] && return 0
    if ! command -v apt-get >/dev/null 2>&1; then
        say "agv-console: this system has no apt-get. Install the equivalents of:$missing"
        return 1
    fi
    as_root=""
    if [ "$(id -u)" != 0 ]; then
        if ! command -v sudo >/dev/null 2>&1; then
            say "agv-console: these packages are missing and sudo is not there to install them. As root:"
            say "    apt-get install --no-install-recommends$missing"
            return 1
        fi
        as_root="sudo"
    fi
    say "agv-console: installing:$missing"
    # The package lists of a fresh system are empty or old; errors of the real install below are the ones to show.
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq update >&2 || true
    # shellcheck disable=SC2086
    if ! $as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -y install --no-install-recommends $missing >&2; then
        say "agv-console: apt-get could not install:$missing"
        say "Check the network and the package sources (on Ubuntu the component 'universe' must be enabled)."
        return 1
    fi
}

# configure PRESET [cmake arguments]: once; later calls cost nothing, ninja re-runs cmake when needed.
configure() {
    preset="$1"
    shift
    [ -f "build/$preset/build.ninja" ] && [ $# -eq 0 ] && return 0
    cmake --preset "$preset" "$@" >&2
}
