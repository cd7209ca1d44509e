// SPDX-License-Identifier: MIT
// A job in a folder of a test, without Slurm.
#pragma once

#include "batch/batch_job.h"
#include "support/run.h"

namespace polhode::test {

// Four tasks of a map of a scene; the folder of the job is FOLDER/maps.job.
inline BatchJob small_job(const TemporaryFolder& folder) {
  BatchJob job;
  job.hash = "0123456789abcdef";
  job.command = "stability";
  job.arguments = {
      "scene.toml", "-o", "maps", "--cells", "4x4", "--methods", "rk4", "--turns", "3"};
  job.program = POLHODE_BINARY;
  job.working_folder = folder.path().string();
  job.output = folder / "maps";
  job.proof = {"stability.csv"};
  job.things = "rows";
  job.pieces = 4;
  job.tasks = 4;
  return job;
}

// With its subfolders.
inline std::filesystem::path make_job_folder(const BatchJob& job) {
  std::filesystem::path made = job_folder_of(job.output);
  std::filesystem::create_directories(made / "state");
  std::filesystem::create_directories(made / "logs");
  write_job(made, job);
  return made;
}

}  // namespace polhode::test
