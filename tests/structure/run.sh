#!/usr/bin/env bash
# run.sh CHECKOUT: what ./run does on a fresh machine, on a ready one and on a foreign one. Stand-ins for the package
# tools, the build and the program write down how they were called.
set -euo pipefail
checkout=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

mkdir -p "$scratch/tree/.ci" "$scratch/tree/build/release/bin" "$scratch/bin" "$scratch/elsewhere"
cp "$checkout/run" "$scratch/tree/"
printf '# a list\nalpha command:sh # there everywhere\nbeta command:no-such-command-beta # nowhere\n' \
  >"$scratch/tree/.ci/packages-build.txt"
printf 'gamma python:no_such_module # nowhere\n' >"$scratch/tree/.ci/packages-test.txt"
printf 'delta command:no-such-command-delta # nowhere\n' >"$scratch/tree/.ci/packages-ranks.txt"
printf 'ID=debian\nVERSION_ID="12"\n' >"$scratch/debian"
printf 'ID=other\nVERSION_ID="1"\n' >"$scratch/other"
calls=$scratch/calls

stand_in() { # NAME BODY
  printf '#!/bin/bash\n%s\n' "$2" >"$scratch/bin/$1"
  chmod +x "$scratch/bin/$1"
}
stand_in dpkg-query 'if grep -qx "${!#}" "$INSTALLED"; then printf installed; else exit 1; fi'
stand_in apt-get 'echo "apt-get $*" >>"$CALLS"
for word; do case $word in alpha|beta|gamma|delta) echo "$word" >>"$INSTALLED";; esac; done'
stand_in cmake 'echo "cmake $*" >>"$CALLS"; echo chatter'
stand_in ctest 'echo "ctest $*" >>"$CALLS"; exit "${CTEST_RESULT:-0}"'
stand_in id 'echo 0'
printf '#!/bin/bash\necho "radcert $*" >>"$CALLS"; echo verdicts; pwd; exit 1\n' >"$scratch/tree/build/release/bin/radcert"
chmod +x "$scratch/tree/build/release/bin/radcert"

export CALLS=$calls INSTALLED=$scratch/installed PATH=$scratch/bin:$PATH
fresh() { : >"$calls"; : >"$INSTALLED"; }

# Runs ./run from another folder and expects an exit code.
call() { # EXPECTED-CODE OS ARGUMENT...
  local code=0
  (cd "$scratch/elsewhere" && RADCERT_OS_RELEASE=$scratch/$2 "$scratch/tree/run" "${@:3}") \
    >"$scratch/out" 2>"$scratch/err" || code=$?
  [ "$code" = "$1" ] || wrong "run ${*:3} on $2 ended with $code, not $1"
}
wrong() { printf '%s\n' "$*" "-- calls:" "$(cat "$calls")" "-- err:" "$(cat "$scratch/err")" >&2; exit 1; }
called() { grep -q -- "$1" "$calls" || wrong "not called: $1"; }
not_called() { ! grep -q -- "$1" "$calls" || wrong "called: $1"; }
said() { grep -q -- "$1" "$scratch/err" || wrong "not said: $1"; }

# A fresh Debian 12: verify installs what it needs and does not find, and not what tests need; the program's exit code is the answer.
fresh
call 1 debian verify ac98 --budget quick
called 'apt-get .* update'
called 'apt-get .*install.* beta$'
not_called gamma
not_called delta
not_called RADCERT_TESTS
called '--target radcert'
called '^radcert verify ac98 --budget quick$'
said '^radcert: installing beta$'
said '^radcert: configuring$'
[ "$(cat "$scratch/out")" = "$(printf 'verdicts\n%s' "$scratch/elsewhere")" ] || wrong "stdout is not the program's alone"

# Once more: nothing is installed.
: >"$calls"
call 1 debian verify
not_called apt-get
called '^radcert verify$'

# The tests need the rest.
call 0 debian test
called 'apt-get .*install.* gamma delta$'
called 'RADCERT_TESTS=ON'
said 'PYTHONPATH='
called '^ctest '
CTEST_RESULT=8 call 1 debian test

# Another system: what is missing is named, nothing is installed.
fresh
call 3 other verify
said 'beta'
! grep -q 'alpha' "$scratch/err" || wrong "alpha is there, by its command"
not_called apt-get
not_called cmake
printf 'alpha\nbeta\n' >"$INSTALLED"
call 1 other verify
not_called apt-get
called '^radcert verify$'

# A configuration or a build that fails is the environment's failure.
stand_in cmake 'echo "the reason"; exit 1'
call 3 other verify
said 'the reason'

call 2 debian
call 2 debian vrify
said "no such verb: 'vrify'"
call 2 debian test something
call 0 debian --help
grep -q 'run verify' "$scratch/out" || wrong "--help does not show verify"
