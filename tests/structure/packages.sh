#!/usr/bin/env bash
# packages.sh CHECKOUT: the package lists are well formed, sorted and free of repetition; .ci/run does both jobs.
set -euo pipefail
cd -- "$1"
status=0
complain() { printf '%s\n' "$*" >&2; status=1; }

for list in .ci/packages-build.txt .ci/packages-test.txt .ci/packages-ranks.txt; do
  entries=$(grep -v '^#' "$list")
  [ -n "$entries" ] || complain "$list: empty"
  while IFS= read -r line; do
    [[ $line =~ ^[a-z0-9][a-z0-9.+-]+\ +(command|header|python):[A-Za-z0-9_./+-]+\ +#\ .+ ]] ||
      complain "$list: not 'package probe # why': $line"
  done <<<"$entries"
  names=$(awk '{print $1}' <<<"$entries")
  [ "$names" = "$(LC_ALL=C sort -u <<<"$names")" ] || complain "$list: not sorted, or a package twice"
done
twice=$(cat .ci/packages-*.txt | grep -v '^#' | awk '{print $1}' | LC_ALL=C sort | uniq -d)
[ -z "$twice" ] || complain "in two lists: $twice"

grep -q 'packages-build.txt' Containerfile || complain "Containerfile: has a package list of its own"
for script in run .ci/run; do
  [ -x "$script" ] || complain "$script: not executable"
  bash -n "$script" || complain "$script: not bash"
done
for verb in test verify; do
  grep -q "./run $verb" .ci/run || complain ".ci/run: does not call ./run $verb"
done
exit "$status"
