# What the scripts of this folder share. Sourced by them: bash, with -e and -u set.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '\n== %s\n' "$*"; }

# need PACKAGE... - install those Debian packages that are missing; elsewhere, say what is needed and go on, since
# the system may have them under other names.
need()
{
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        echo "This is no Debian: please see that you have what these Debian packages hold: $*"
        echo "The plain CMake commands are in README.md, \"On another system\"."
        return
    fi
    local package missing=()
    for package in "$@"; do
        dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] && return
    say "Installing ${missing[*]}"
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || {
            echo "Not root, and there is no sudo. As root, run:  apt-get install ${missing[*]}" >&2
            exit 1
        }
        as_root=(sudo)
    fi
    export DEBIAN_FRONTEND=noninteractive
    "${as_root[@]}" apt-get update -qq
    "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# All tools build in one folder, so that the library is compiled once; each switches its own part on.
# build FOLDER TARGET CMAKE-OPTION... - configure and build in build/FOLDER, quietly unless it fails.
build()
{
    local folder=$root/build/$1 target=$2
    shift 2
    say "Building in ${folder#"$root"/}"
    mkdir -p "$folder"
    if ! cmake -S "$root" -B "$folder" "$@" >"$folder/configure.log" 2>&1; then
        tail -n 30 "$folder/configure.log"
        exit 1
    fi
    cmake --build "$folder" --target "$target" --parallel "$(nproc)" -- --no-print-directory |
        { grep --line-buffered -vE 'Built target|Consolidate|Scanning dependencies|Building C|Linking' || true; }
    [ "${PIPESTATUS[0]}" -eq 0 ]
}

# A Python that has the given module: the one on the PATH may not see Debian's packages.
python_with()
{
    local candidate
    for candidate in python3 /usr/bin/python3; do
        if "$candidate" -c "import $1" 2>/dev/null; then
            echo "$candidate"
            return
        fi
    done
    echo "no python3 has the module $1" >&2
    return 1
}
