#!/usr/bin/env bash
# Whether the job fails, once everything is uploaded.
set -euo pipefail
case "$STATUS/$FAIL_ON" in
  0/* | 1/errors | 1/nothing) ;;
  1/*)
    echo "::error::The proofreader found something."
    exit 1
    ;;
  2/nothing) echo "::warning::An option is wrong, or a file could not be read; the other files were." ;;
  *)
    echo "::error::An option is wrong, or a file could not be read; the log of the step before says which."
    exit 2
    ;;
esac
