# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# What all scripts share; sourced, not run.
set -euo pipefail
export LC_ALL=C.UTF-8

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
logs=$root/build/logs

status() { printf 'lume: %s\n' "$*" >&2; }

# run_logged NAME COMMAND...: keeps the output in build/logs/NAME.log, shown only if it fails.
run_logged() {
  local log=$logs/$1.log
  shift
  mkdir -p "$logs"
  if ! "$@" >"$log" 2>&1; then
    tail -n 100 "$log" >&2
    status "failed: $* (whole log: $log)"
    return 1
  fi
}
