#!/usr/bin/env bash
# ./course new NAME makes a stage that builds, passes its tests and plays at once; and the example of
# docs/contributing.md works as it stands there: this test runs its commands and makes its changes. All in a
# copy of the project, built without windows.
# usage: new_stage_test.sh TOP
set -uo pipefail
top=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
copy="$folder/bounce"
mkdir "$copy"
cp -R "$top"/{CMakeLists.txt,CMakePresets.json,course,common,docs,stages,tests} "$copy"
cd "$copy" || exit 1
rm -rf stages/09_* stages/[1-9][0-9]_* docs/09_* stages/*/mine.hpp* # somebody's own work stays out of this
rm tests/checks/0[1-8]_*_check.cpp # and the checks of the other stages take a minute to build
unset BOUNCE_MINE
export CCACHE_BASEDIR=$copy # an object of the same text is taken over from another folder
export BOUNCE_LANG=en # what is said is compared
failures=0
out=''
fails() { printf 'FAILED: %s:\n%s\n' "$1" "$out"; failures=$((failures + 1)); }
run() { # run CODE ARGS...: ./course ARGS must end with that code; its output is in $out
  local wanted=$1 code=0; shift
  out=$(./course "$@" 2>&1) || code=$?
  [ "$code" -eq "$wanted" ] || fails "./course $* ended with $code, not $wanted"
}
shows() { grep -qF -- "$1" <<<"$out" || fails "the output lacks '$1'"; }
rows() { ./course "$@" 2>/dev/null; }
equal() { cmp -s "$1" "$2" || fails "$3"; }

mkdir -p build/release
cmake --preset release -DBOUNCE_APP=OFF -DBOUNCE_WERROR=ON >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }

# Names that cannot be: one sentence, and nothing is made.
before=$(find . -path ./build -prune -o -print | sort)
for name in '' Drag 9lives air-drag _drag air__drag 'air drag' ../drag damping energy mine gaps; do
  run 2 new "$name"
  shows "new cannot take the name '$name'"
done
run 2 new; shows "./course new NAME"
run 2 new one two
out=$(diff <(echo "$before") <(find . -path ./build -prune -o -print | sort)) || fails "a name that was refused left something"

# A fresh stage is stage 3 under another name.
page_commands() { # of the example, in their order; and EDIT, where its changes begin
  awk '/^## / { on = /A stage of your own/ } /^### / { on = 0 } !on { next }
    /^```/ { shell = /^```sh/; if (/^```diff/ && !edit++) print "EDIT" } shell && /^\.\/course/' docs/contributing.md
}
commands=()
while IFS= read -r command; do commands+=("$command"); done < <(page_commands)
[ "${#commands[@]}" -ge 9 ] || fails "the example of docs/contributing.md has lost its commands: ${commands[*]}"
edited=
for command in "${commands[@]}"; do
  read -ra words <<<"${command#./course }"
  case ${words[*]} in
    EDIT)
      run 1 check 9; shows "0 in every case" # the skeleton fails, and the solution passes
      cp stages/09_drag/drag.hpp stages/09_drag/mine.hpp
      run 0 check 9
      rows play 9 --headless --sample 0.1 --csv own.csv
      rows play 9 --mine --headless --sample 0.1 --csv mine.csv
      equal own.csv mine.csv "a learner's program on the same lines gives another trace"
      rm stages/09_drag/mine.hpp*
      run 2 new drag; shows "there is a stage 09_drag"
      equal <(rows plain 9) <(rows plain 3) "the new stage does not move as stage 3"
      out=$(awk -f tests/new_stage/follow_page.awk docs/contributing.md) || fails "docs/contributing.md cannot be followed"
      edited=1 ;;
    'check 9') run 1 check 9; shows "0 in every case" ;;
    play*) run 0 "${words[@]}" --headless ;;
    *) run 0 "${words[@]}" ;;
  esac
done
[ -n "$edited" ] || fails "the example of docs/contributing.md changes nothing"

# What has come of it.
shows 'compared_with="reference, 1e-14"'
shows "position_error_m=" # of the page's last command: with air there is no formula, and yet an error
out=$(build/release/bin/09_drag_tests -ltc); shows "terminal speed"
out=$(build/release/bin/09_drag --list); shows "force of the air per speed squared"
cp stages/09_drag/drag.hpp stages/09_drag/mine.hpp
run 0 check 9
sed -i.bak 's/ - drag \* std::abs(v) \* v//' stages/09_drag/mine.hpp
run 1 check 9; shows "no air"
sed -i.bak 's/std::abs(v) \* v/std::abs(v)/' stages/09_drag/plain.cpp
run 1 test 9; shows "the program on one page prints the same rows"

[ "$failures" -eq 0 ] || { echo "$failures failures"; exit 1; }
echo "a new stage builds, runs, and becomes what docs/contributing.md says"
