#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# `meniscus batch` as a Slurm array: every task computes its part of the inputs (docs/howto/slurm.md).
#
#   job=$(sbatch --parsable --array=0-3 tools/slurm/meniscus-array.sh measure STRUCTURES --out RESULTS [OPTIONS])
#   sbatch --dependency=afterany:"$job" --wrap "meniscus batch measure --out RESULTS --collect"
#
# The second command puts the results of all tasks together. A task that ends with 0 has done its part: every input of it
# has a line of results, be it of a failure. Whatever ended a task before, the same command goes on where it was.
#
# What sbatch is given goes before what stands here. Every CPU computes one input at a time and no input gets more memory
# than --mem-per-cpu, so that Slurm has no reason to end the task.
#SBATCH --job-name=meniscus
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --cpus-per-task=1
#SBATCH --mem-per-cpu=2G
set -euo pipefail

if [ $# -eq 0 ] || [ -z "${SLURM_ARRAY_TASK_ID-}" ]; then
    echo "usage: sbatch --array=0-3 $(basename "$0") surface|measure INPUTS --out DIR [options of meniscus batch]" >&2
    exit 2
fi

code=0
meniscus batch "$@" --resume --jobs "$SLURM_CPUS_PER_TASK" --threads 1 --memory-limit "${SLURM_MEM_PER_CPU}M" || code=$?
# Some inputs failed: the part is done all the same. Collecting ends with 6 for it.
if [ "$code" -eq 6 ]; then exit 0; fi
exit "$code"
