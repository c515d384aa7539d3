#!/usr/bin/env bash
# Where the program of the action is, and a name of what it is built from, under which it is kept between runs.
set -euo pipefail
cd "$GITHUB_ACTION_PATH"
source=$(find Cargo.toml Cargo.lock crates/proofread crates/host -type f | LC_ALL=C sort | git hash-object --no-filters --stdin-paths |
  git hash-object --stdin)
{
  echo "folder=$RUNNER_TEMP/proofread-program"
  echo "source=$source"
} >>"$GITHUB_OUTPUT"
