#!/usr/bin/env bash
# ./course where nobody may install anything: it builds what it can, or says what is missing. On a system of this
# test's own: a folder with a few of this one's commands, and others that only pretend.
# usage: no_root_test.sh TOP
set -uo pipefail
top=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export BOUNCE_LANG=en
failures=0
fails() { printf 'FAILED: %s\n' "$1"; cat "$folder/said"; failures=$((failures + 1)); }
mkdir -p "$folder/bin" "$folder/course/stages/01_fall"
touch "$folder/course/stages/01_fall/main.cpp"
cp "$top/course" "$folder/course"
for tool in bash basename cat chmod dirname env grep mkdir readlink sed tail tr; do
  ln -s "$(type -P $tool)" "$folder/bin"
done
pretend() { cat >"$folder/bin/$1"; chmod +x "$folder/bin/$1"; }
pretend id <<<'#!/bin/sh
echo 1000'
pretend apt-get <<<'#!/bin/sh
echo apt-get was called; exit 1'
pretend dpkg-query <<<'#!/bin/sh
for one; do case $one in libsdl2-dev | -*) ;; *) echo "$one install ok installed" ;; esac; done'
pretend cmake <<'TEXT'
#!/bin/sh
[ "$1" = --build ] || { echo >build/release/build.ninja; exit 0; }
mkdir -p build/release/bin
printf '#!/bin/sh\necho it falls\n' >build/release/bin/01_fall
chmod +x build/release/bin/01_fall
TEXT
course() { # course CODE
  local code=0
  PATH=$folder/bin "$folder/course/course" play 1 >"$folder/said" 2>&1 || code=$?
  [ "$code" -eq "$1" ] || fails "exit code $code, not $1"
  ! grep -q 'apt-get' "$folder/said" || fails "it tries to install"
}

course 2 # no compiler
grep -q 'these packages are missing, and installing them needs root: libsdl2-dev$' "$folder/said" || fails "it does not say what is missing"
for tool in c++ ninja; do ln -s "$(type -P true)" "$folder/bin/$tool"; done
course 0
grep -q 'going on without these packages, since installing them needs root: libsdl2-dev$' "$folder/said" || fails "it does not say what is left out"
grep -qx 'it falls' "$folder/said" || fails "it builds nothing"
exit $((failures > 0))
