// SPDX-License-Identifier: MIT
// Folders of jobs in each state, without Slurm; what Slurm says is tested by
// tests/commands/cluster.py.
#include "batch/task_states.h"

#include "batch/job_folders.h"

namespace polhode {
namespace {

using test::TemporaryFolder;

class TaskStates : public ::testing::Test {
 protected:
  TaskStates() : job_(test::small_job(folder_)) {
    job_.submissions = {{"999999991", "999999992", {1, 2, 3, 4}}};
    place_ = test::make_job_folder(job_);
  }
  JobState state() const { return state_of_job(place_, job_); }
  std::string words() const { return words_of_state(place_, job_, state()); }

  TemporaryFolder folder_;
  BatchJob job_;
  std::filesystem::path place_;
};

TEST_F(TaskStates, OfAJobThatHasNotBegun) {
  EXPECT_EQ(state().count(TaskProgress::not_begun), 4);
  EXPECT_FALSE(state().is_active());
  EXPECT_EQ(exit_code_of(state()), 0);
  EXPECT_NE(words().find("maps: 0 of 4 tasks done, 4 not begun; not collected"), std::string::npos)
      << words();
}

TEST_F(TaskStates, TellTheLineThatExplainsAFailure) {
  test::write_text(mark_of_task(place_, 1, "done"), "");
  test::write_text(mark_of_task(place_, 2, "failed"), "3\n");
  test::write_text(log_of_task(place_, 2),
                   "task 2 of 4 on node1, 2026-01-01 00:00:00\npolhode: an older failure\n"
                   "task 2 of 4 on node2, 2026-01-01 00:01:00\n"
                   "polhode: maps/x: cannot be written: No space left on device\nbye\n");
  // killed before it could leave a mark
  test::write_text(log_of_task(place_, 3),
                   "task 3 of 4 on node1, 2026-01-01 00:00:00\n"
                   "slurmstepd: error: *** JOB 3 ON node1 CANCELLED DUE TO TIME LIMIT ***\n");
  const std::string said = words();
  EXPECT_NE(said.find("1 of 4 tasks done, 2 failed, 1 not begun"), std::string::npos) << said;
  EXPECT_NE(said.find("task 2: exit code 3: polhode: maps/x: cannot be written: No space left on "
                      "device (" +
                      log_of_task(place_, 2).string() + ")"),
            std::string::npos)
      << said;
  EXPECT_EQ(said.find("an older failure"), std::string::npos) << said;
  EXPECT_NE(
      said.find("task 3: killed: slurmstepd: error: *** JOB 3 ON node1 CANCELLED DUE TO TIME"),
      std::string::npos)
      << said;
  EXPECT_EQ(exit_code_of(state()), 1);
}

TEST_F(TaskStates, OfAProductThatIsThere) {
  std::filesystem::create_directory(folder_ / "maps");
  test::write_text(place_ / "state/collected", "");
  EXPECT_FALSE(state().made);
  test::write_text(folder_ / "maps/stability.csv", "");
  EXPECT_TRUE(state().made);
  EXPECT_NE(words().find("4 of 4 tasks done; collected"), std::string::npos) << words();
}

// its tasks did not fail
TEST_F(TaskStates, OfAProductThatWasDeleted) {
  test::write_text(place_ / "state/collected", "");
  test::write_text(log_of_task(place_, 1), "task 1 of 4 on node1\npolhode: maps: all rows\n");
  EXPECT_TRUE(state().lost);
  EXPECT_FALSE(state().is_active());
  EXPECT_EQ(exit_code_of(state()), 0);
  EXPECT_EQ(words(), folder_ / "maps" + " was made, and is not there any more; submit it again\n");
}

TEST_F(TaskStates, OfACollectionThatFailed) {
  for (int task = 1; task <= 4; ++task)
    test::write_text(mark_of_task(place_, task, "done"), "");
  test::write_text(place_ / "state/collect.failed", "3\n");
  test::write_text(place_ / "logs/collect.log", "polhode: gnuplot is not installed\n");
  EXPECT_NE(words().find("collecting: exit code 3: polhode: gnuplot is not installed ("),
            std::string::npos)
      << words();
  EXPECT_EQ(exit_code_of(state()), 1);
}

TEST_F(TaskStates, SettleAtOnceWhereNothingIsOnItsWay) {
  EXPECT_EQ(settled_state(place_, job_).count(TaskProgress::not_begun), 4);
}

}  // namespace
}  // namespace polhode
