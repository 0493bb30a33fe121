#!/usr/bin/env bash
# The coefficients in the repository are those that their generator writes.
set -euo pipefail
cd "$(dirname "$0")"
./kernel_coefficients.py | diff - ../src/generated/kernel_coefficients.h
