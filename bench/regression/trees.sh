# For bench/check and bench/certify, which source it at the top of the tree: builds what is measured
# and has it measured.

place=$PWD/build/check
report=build/release/report/desmo_report
check=build/release/bench/desmo_check

quietly() {  # COMMAND...: shows what it says only when it fails
  "$@" >"$place/build.log" 2>&1 || { cat "$place/build.log" >&2; return 70; }
}

build() {  # SOURCE TARGET...
  local source=$1
  shift
  (cd "$source" && quietly cmake --preset release &&
    quietly cmake --build --preset release --target "$@") || exit $?
}

copy_head() {  # SIDE: this tree's programs, as those of a side
  mkdir -p "$place/$1"
  cp build/release/bench/desmo_probe build/release/bench/desmo_steps "$place/$1"
}

prepare_head() {
  mkdir -p "$place"
  bench/prepare build
  echo "Building this tree ..." >&2
  build . desmo_probe desmo_steps desmo_check desmo_report
  copy_head head
}

prepare_base() {  # REF
  local commit tree=$place/tree
  commit=$(git rev-parse --verify --quiet "$1^{commit}") ||
    { echo "bench/check: there is no commit '$1'" >&2; exit 64; }
  [ -e "$tree/.git" ] || { git worktree prune && git worktree add --quiet --detach "$tree" "$commit"; }
  git -C "$tree" checkout --quiet --force --detach "$commit"
  [ -e "$tree/bench/regression/probe.cpp" ] ||
    { echo "bench/check: $1 is older than the check and cannot be measured" >&2; exit 4; }
  echo "Building $1 (${commit:0:12}) ..." >&2
  build "$tree" desmo_probe desmo_steps
  mkdir -p "$place/base"
  cp "$tree"/build/release/bench/desmo_{probe,steps} "$place/base"
}

# Measures, and measures again what the verdict still needs: the second pass of an alarm, more rounds
# of what is too noisy.
measure() {  # FILE BASE HEAD BASELINE FLAG...: BASE and BASELINE may be empty
  local file=$1 baseline=$4 sides=(${2:+--base "$place/$2"} --head "$place/$3") attempt pass cells
  shift 4
  "$check" "${sides[@]}" measure "$file" "$@" || return
  for attempt in 1 2 3 4; do
    "$report" check "$file" ${baseline:+--baseline "$baseline"} --pending >"$file.pending" || return
    for pass in first second; do
      mapfile -t cells < <(awk -v pass=$pass '$1 == pass {print $2}' "$file.pending" | sort -u)
      [ ${#cells[@]} -eq 0 ] || "$check" "${sides[@]}" more "$file" "$pass" "${cells[@]}" || return
    done
    [ -s "$file.pending" ] || break
  done
  rm -f "$file.pending"
}
