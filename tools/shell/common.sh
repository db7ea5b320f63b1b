# Shared by the scripts of tools/; source it.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=$(basename "$0")

# say TEXT: one line for the user.
say() { printf '%s: %s\n' "$program" "$*"; }

# fail TEXT: one line on stderr, what is wrong and how to mend it; ends the script.
fail() {
  printf '%s: %s\n' "$program" "$*" >&2
  exit 1
}

# Compilers to run at once: one a core, and 1.5 GB of memory each.
build_jobs() {
  local cores memory_kb by_memory
  cores=$(nproc)
  memory_kb=$(awk '/^MemAvailable:/ { print $2 }' /proc/meminfo)
  by_memory=$((${memory_kb:-0} / 1500000))
  ((by_memory >= 1)) || by_memory=1
  echo $((cores < by_memory ? cores : by_memory))
}

# use_compiler_cache: ccache, if it is there, knows what another clone of the same sources has compiled.
use_compiler_cache() {
  command -v ccache >/dev/null || return 0
  export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-ccache}
  # Precompiled headers: without these it takes no source that comes with one.
  export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS-pch_defines,time_macros}
  export CCACHE_BASEDIR=${CCACHE_BASEDIR-$root} CCACHE_NOHASHDIR=${CCACHE_NOHASHDIR-1}
}

# build_quadrille FOLDER ARGUMENT…: configures a Release build in FOLDER with the arguments of
# QUADRILLE_CMAKE_ARGS, and builds; the arguments go to cmake --build.
build_quadrille() {
  local folder=$1 extra=()
  shift
  read -r -a extra <<<"${QUADRILLE_CMAKE_ARGS:-}"
  use_compiler_cache
  local log=$folder/configure.log
  mkdir -p "$folder"
  cmake -S "$root" -B "$folder" -DCMAKE_BUILD_TYPE=Release "${extra[@]}" >"$log" 2>&1 || {
    tail -n 20 "$log" >&2
    fail "cmake could not configure $folder; its output is in $log"
  }
  cmake --build "$folder" -j "$(build_jobs)" "$@" | sed -u '/Built target/d' ||
    fail "the build in $folder failed"
}
