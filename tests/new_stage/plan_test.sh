#!/usr/bin/env bash
# ./course check plan sends back what is no plan, in words, and passes what is one.
# usage: plan_test.sh TOP
set -uo pipefail
top=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export BOUNCE_LANG=en # what is said is compared
failures=0
fails() { printf 'FAILED: %s:\n%s\n' "$1" "$out"; failures=$((failures + 1)); }
plan() { # plan CODE: the plan on standard input
  local code=0
  cat >"$folder/plan.md"
  out=$("$top/course" check plan "$folder/plan.md" 2>&1) || code=$?
  [ "$code" -eq "$1" ] || fails "it ended with $code, not $1"
}
shows() { grep -qF -- "$1" <<<"$out" || fails "it does not say '$1'"; }
lines() { [ "$(wc -l <<<"$out")" -eq "$1" ] || fails "there are not $1 lines"; }
item() { printf '## %s\ndays: %s\nsee: %s\nnumber: %s\n' "$@"; }

# The plans of the page, each on its own.
awk -v folder="$folder" '/^```text/ { inside = 1; n++; next } /^```/ { inside = 0 }
  inside { print >(folder "/page" n) }' "$top/docs/your_project.md" "$top/docs/ja/your_project.md"
for n in 1 2 3; do plan 0 <"$folder/page$n"; shows "4 items"; shows "Begin with the first: A ball"; done
for n in 4 5 6; do plan 0 <"$folder/page$n"; shows "4 items"; done # in Japanese
[ ! -e "$folder/page7" ] || fails "there is a fourth plan, which this test does not know"

plan 0 < <(item falls 1 'it falls' 7.00; item bounces 2-4 'it bounces' 0.66)
shows "2 items, 4 days"

# What is sent back: the item, its line, and why. Nothing else.
plan 1 < <(item falls 1 'it falls' 7.00; item bounces 2-5 'it bounces' 0.66)
shows "plan.md:5: 'bounces' takes 4 days."; lines 1
plan 1 < <(item falls 1 'it falls' 7.00; item bounces 2-4 'it bounces' '...')
shows "plan.md:5: 'bounces' has no check."; lines 1
plan 1 < <(item falls 1 'it falls' 'sqrt(m g / b)'); shows "'falls' has a check without a number: 'sqrt(m g / b)'."; lines 1
plan 1 < <(item falls 1 '' 7.00); shows "plan.md:1: 'falls' shows nothing."; lines 1
plan 1 < <(item falls '' 'it falls' 7.00); shows "plan.md:1: 'falls' has no day."; lines 1
for days in soon 1-x 1.5; do plan 1 < <(item falls $days 'it falls' 7.00); shows "'falls' has the days '$days'."; lines 1; done
for days in 0 3-2; do plan 1 < <(item falls $days 'it falls' 7.00); shows "Count from day 1, upwards."; lines 1; done
plan 1 < <(item falls 2-3 'it falls' 7.00; item bounces 1 'it bounces' 0.66)
shows "'bounces' begins on day 1, and the item before it ends on day 3."; lines 1
plan 1 < <(printf '## falls\n## bounces\n'); lines 6
plan 1 < <(printf '# only words\n\nit shall fly\n'); shows "there is no item in it"; lines 1
plan 1 <"$top/stages/new/plan.md"; lines 4 # a fresh one is no plan yet
plan 0 < <(item falls 1 'it falls' 7.00 | awk '{ sub(/^days/, "- Days"); printf "%s\r\n", $0 }') # as another editor writes it

out=$("$top/course" check plan "$folder/not_there.md" 2>&1) && fails "a file that is not there passes"
shows "cannot find the file '$folder/not_there.md'"
out=$("$top/course" check plan 3 2>&1) && fails "stage 3 has no plan, and passes"
shows "stage 03_damping has no plan.md"

[ "$failures" -eq 0 ] || { echo "$failures failures"; exit 1; }
echo "plans are read"
