# Sourced by ../run and ../test: what both need before they build. All its messages go to standard error.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '%s\n' "$*" >&2; }

# install_packages [LIST]: installs the packages of scripts/LIST.txt that are missing. A stamp in build/ keeps later calls
# short.
install_packages() {
  local list=$root/scripts/${1:-packages}.txt stamp=$root/build/.${1:-packages} missing=() package
  [[ $stamp -nt $list ]] && return
  while read -r package; do
    [[ -z $package || $package == '#'* ]] && continue
    dpkg -s "$package" 2>/dev/null | grep -q '^Status: install ok installed' || missing+=("$package")
  done <"$list"
  if ((${#missing[@]})); then
    local sudo=()
    if ((EUID != 0)); then
      if ! command -v sudo >/dev/null; then
        say "These packages are missing: ${missing[*]}"
        say "Install them as root: apt-get install ${missing[*]}"
        exit 2
      fi
      sudo=(sudo)
    fi
    say "Installing ${missing[*]} …"
    local log=$root/build/packages.log
    mkdir -p "$root/build"
    if ! { "${sudo[@]}" apt-get update -q && "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive \
      apt-get install -q -y --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
      cat "$log" >&2
      say "The packages could not be installed (see above): ${missing[*]}"
      exit 2
    fi
  fi
  mkdir -p "$root/build"
  touch "$stamp"
}

# build PRESET TARGET…: configures build/PRESET once, or again for options that it does not have yet, then lets ninja decide
# what to do and says how far it is. `options` (an array of the caller): for CMake. In CI (CI=true) warnings are errors;
# elsewhere a newer compiler's new warning must not stop the build.
build() {
  local preset=$1 folder=$root/build/$1 log=$root/build/$1.log option configured=true
  shift
  [[ ${CI:-} == true ]] && options+=(-DGAPCHECK_WERROR=ON)
  [[ -f $folder/build.ninja ]] || configured=false
  for option in ${options[@]+"${options[@]}"}; do
    option=${option#-D}
    grep -qs "^${option%%=*}:BOOL=${option#*=}$" "$folder/CMakeCache.txt" || configured=false
  done
  if [[ $configured == false ]]; then
    say "Configuring $preset …"
    if ! (cd "$root" && cmake --preset "$preset" ${options[@]+"${options[@]}"}) >"$log" 2>&1; then
      cat "$log" >&2
      exit 2
    fi
  fi
  # On a terminal ninja keeps one line up to date. Elsewhere a line at each quarter of a long build is enough, and of what
  # the compiler says only what goes wrong is of interest.
  if [[ -t 2 ]]; then
    NINJA_STATUS='Building: step %f of %t, %es  ' ninja -C "$folder" "$@" >&2 || exit 2
  elif ! ninja -C "$folder" "$@" 2>&1 | tee "$log" | tell_quarters; then
    grep -v -e '^\[' -e '^ninja: Entering' "$log" >&2
    exit 2
  fi
}

# Reads "[STEP/ALL] …" and says, of builds with more than ten steps, when a quarter, a half and three quarters are done.
tell_quarters() {
  awk '/^\[[0-9]+\/[0-9]+\]/ {
    split(substr($1, 2), step, /[\/\]]/)
    done = int(4 * step[1] / step[2])
    if (step[2] > 10 && done > told && done < 4) { told = done; print 25 * done " % built"; fflush() }
  }' >&2
}
