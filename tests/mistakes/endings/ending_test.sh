#!/usr/bin/env bash
# ending_test.sh BUILD TOP FILE: code that ends in another way than by an answer. It takes the place of the
# right lines of stage 1 (or of `// stage: NN_name`), is judged as ./course check does it, and the learner
# must read each sentence of its lines `// says: ...`.
# `// include: NAME` and `// change: SED` are done to the whole file; `// passes`: it is right all the same.
set -uo pipefail
build=$1 top=$2 file=$3
stage=$(sed -n 's|^// stage: ||p' "$file")
stage=${stage:-01_free_fall}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
header=$(sed -n 's|^#define BOUNCE_STAGE_HEADER "\(.*\)"|\1|p' "$top/tests/checks/subjects/$stage.cpp")
cp "$top/stages/$header" "$folder/mine.hpp"
if grep -q '^ *// \[' "$file"; then
  cmake -DBASE="$top/stages/$header" -DPIECES="$file" -DOUT="$folder/mine.hpp" -P "$top/tests/checks/splice.cmake"
fi
while IFS= read -r name; do
  sed -i.old "1,/^#include/s|^#include|#include <$name>\n#include|" "$folder/mine.hpp"
done < <(sed -n 's|^// include: ||p' "$file")
change=$(sed -n 's|^// change: ||p' "$file")
[ -z "$change" ] || sed -i.old "$change" "$folder/mine.hpp"

code=0
out=$(
  if ! "$build/checks/compile_stage" "$stage" "$folder/mine.hpp" "$folder/module" -fmax-errors=1 2>"$folder/log"; then
    "$top/tests/checks/compiler_said.sh" errors "$folder/log" "$folder/mine.hpp" mine.hpp
    exit 1
  fi
  ended=0
  "$build/bin/stage_checks" "$stage" "$folder/module" --course "$folder/module" || ended=$?
  "$top/tests/checks/compiler_said.sh" warnings "$folder/log" "$folder/mine.hpp" mine.hpp
  exit "$ended"
) || code=$?
failures=0
wanted=1
if grep -q '^// passes' "$file"; then wanted=0; fi
[ "$code" -eq "$wanted" ] || { echo "ended with $code, not $wanted"; failures=1; }
while IFS= read -r sentence; do
  grep -qF -- "$sentence" <<<"$out" || { echo "the learner does not read: $sentence"; failures=1; }
done < <(sed -n 's|^// says: ||p' "$file")
[ "$(wc -l <<<"$out")" -le 40 ] || { echo "that is too long to be read"; failures=1; }
[ "$failures" -eq 0 ] || { head -n 60 <<<"$out"; exit 1; }
