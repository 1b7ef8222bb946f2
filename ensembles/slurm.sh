#!/bin/bash
# Computes a study as an array of jobs of Slurm: `sbatch ensembles/slurm.sh`. Each job computes one shard into the common
# folder. If a job is cancelled or its node dies, resubmit it alone with `sbatch --array=K ensembles/slurm.sh`; it
# continues after its finished chunks.
#SBATCH --job-name=flip_map
#SBATCH --array=1-16
#SBATCH --cpus-per-task=32
#SBATCH --time=04:00:00
set -euo pipefail

# The number of shards, also where a single job is submitted again.
shards=16

srun target/release/examples/flip_map --size 10000 --folder "$SLURM_SUBMIT_DIR/flip_map" \
    --threads "$SLURM_CPUS_PER_TASK" --shard "$SLURM_ARRAY_TASK_ID/$shards"
