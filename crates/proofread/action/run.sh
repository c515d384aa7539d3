#!/usr/bin/env bash
# Runs the proofreader for the action, once for people and once for code review. What comes from the inputs is in variables and in
# arrays, so no shell reads it as a command. The bash of macOS is 3.2: it has no `mapfile`, and takes an empty array for an unset one.
set -euo pipefail

case "$FAIL_ON" in
  findings | errors | nothing) ;;
  *)
    echo "fail-on is '$FAIL_ON'; it is findings, errors or nothing" >&2
    exit 2
    ;;
esac

# lines TEXT: its lines without the space around them, in the array `found`; blank ones are left out.
lines() {
  found=()
  local line
  while IFS= read -r line || [[ -n "$line" ]]; do
    line="${line#"${line%%[![:space:]]*}"}"
    line="${line%"${line##*[![:space:]]}"}"
    if [[ -n "$line" ]]; then found+=("$line"); fi
  done <<<"$1"
}

arguments=()
lines "$OPTIONS"
arguments+=(${found[@]+"${found[@]}"})
if [[ -n "$SINCE" ]]; then arguments+=("--since=$SINCE"); fi
if [[ -n "$BASELINE" ]]; then arguments+=("--baseline=$BASELINE"); fi
lines "$FILES"
arguments+=(-- ${found[@]+"${found[@]}"})

program=$(find "$FOLDER/bin" -name 'proofread*' -type f 2>/dev/null | head -n 1 || true)
if [[ -z "$program" ]]; then
  cargo install --quiet --locked --path "$GITHUB_ACTION_PATH/crates/proofread" --root "$FOLDER"
  program=$(find "$FOLDER/bin" -name 'proofread*' -type f | head -n 1)
fi

# What texts print is no command for the runner.
token=$(od -An -N16 -tx1 /dev/urandom | tr -d ' \n')
echo "::stop-commands::$token"
status=0
"$program" "${arguments[@]}" || status=$?
sarif="$RUNNER_TEMP/proofread.sarif"
"$program" --format sarif "${arguments[@]}" >"$sarif" 2>/dev/null || true
echo "::$token::"

{
  echo "status=$status"
  if [[ -s "$sarif" ]]; then echo "sarif-file=$sarif"; fi
} >>"$GITHUB_OUTPUT"
