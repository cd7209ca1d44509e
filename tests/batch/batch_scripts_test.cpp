// SPDX-License-Identifier: MIT
// The scripts are run here by sh, as Slurm would run them.
#include "batch/batch_scripts.h"

#include "app/commands/stability.h"
#include "app/piecewise.h"
#include "base/error.h"
#include "base/system/child_process.h"
#include "batch/job_folders.h"
#include "batch/task_states.h"
#include "support/scenes.h"

namespace polhode {
namespace {

using test::read_text;
using test::TemporaryFolder;

class BatchScripts : public ::testing::Test {
 protected:
  // the folder's name is what shells would like to take for something else
  BatchScripts() : place_(folder_ / "it's $(false) \"100%\" #;") {
    std::filesystem::create_directory(place_);
    test::write_text(place_ + "/-scene &.toml", test::kSmallScene);
    job_ = test::small_job(folder_);
    job_.arguments[0] = "./-scene &.toml";
    job_.working_folder = place_;
    job_.output = place_ + "/maps";
    StabilityJob stability;
    stability.scenes = {place_ + "/-scene &.toml"};
    stability.output = job_.output;
    stability.cells = "4x4";
    stability.methods = "rk4";
    stability.turns = 3;
    job_.hash = hash_of_work(divided_stability(stability).words);
    job_folder_ = test::make_job_folder(job_);
    test::write_text(job_folder_ / "tasks.sh", task_script(job_, job_folder_, {}));
    test::write_text(job_folder_ / "collect.sh", collecting_script(job_, job_folder_, {}));
  }
  ChildResult run_task(int task) const {
    return run_child({"env",
                      "SLURM_ARRAY_TASK_ID=" + std::to_string(task),
                      "sh",
                      (job_folder_ / "tasks.sh").string()},
                     "");
  }
  ChildResult collect() const {
    return run_child({"sh", (job_folder_ / "collect.sh").string()}, "");
  }

  TemporaryFolder folder_;
  std::string place_;
  BatchJob job_;
  std::filesystem::path job_folder_;
};

TEST_F(BatchScripts, MakeWhatAnUndividedRunMakes) {
  for (int task = 1; task <= 4; ++task) {
    const ChildResult ran = run_task(task);
    ASSERT_EQ(ran.status, 0) << ran.out << ran.err;
  }
  const ChildResult ran = collect();
  ASSERT_EQ(ran.status, 0) << ran.out << ran.err;
  EXPECT_TRUE(is_made(job_folder_, job_));
  EXPECT_FALSE(std::filesystem::exists(mark_of_task(job_folder_, 1, "done")));
  const ChildResult whole = run_child({"sh",
                                       "-c",
                                       "cd \"$1\" && \"$2\" stability './-scene &.toml' -o whole "
                                       "--cells 4x4 --methods rk4 --turns 3",
                                       "sh",
                                       place_,
                                       POLHODE_BINARY},
                                      "");
  ASSERT_EQ(whole.status, 0) << whole.err;
  EXPECT_EQ(read_text(place_ + "/maps/stability.csv"), read_text(place_ + "/whole/stability.csv"));
}

TEST_F(BatchScripts, CollectNothingWhileATaskIsMissing) {
  for (const int task : {1, 2, 4})
    ASSERT_EQ(run_task(task).status, 0);
  const ChildResult ran = collect();
  EXPECT_EQ(ran.status, 1);
  EXPECT_NE(ran.out.find("3 of 4 tasks done, 1 not begun"), std::string::npos) << ran.out;
  EXPECT_EQ(read_text(job_folder_ / "state/collect.failed"), "1\n");
  EXPECT_FALSE(std::filesystem::exists(place_ + "/maps/stability.csv"));
}

TEST_F(BatchScripts, StopIfTheSceneHasChanged) {
  std::string changed = test::kSmallScene;
  changed += "[[story]]\nat = 0\ncaption = \"Another film\"\n";
  test::write_text(place_ + "/-scene &.toml", changed);
  const ChildResult ran = run_task(1);
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("has changed since " + job_.hash + " was submitted"), std::string::npos)
      << ran.err;
  EXPECT_EQ(read_text(mark_of_task(job_folder_, 1, "failed")), "2\n");
}

TEST_F(BatchScripts, PassOnWhatSlurmIsToKnow) {
  SlurmOptions options;
  options.partition = "long";
  options.time = "1:00:00";
  options.memory = "4G";
  options.account = "physics";
  options.more = "--qos=low --nice=100";
  options.at_once = 7;
  for (const std::string& script :
       {task_script(job_, job_folder_, options), collecting_script(job_, job_folder_, options)}) {
    for (const char* line : {"#SBATCH --partition=long\n",
                             "#SBATCH --time=1:00:00\n",
                             "#SBATCH --mem=4G\n",
                             "#SBATCH --account=physics\n",
                             "#SBATCH --qos=low --nice=100\n"})
      EXPECT_NE(script.find(line), std::string::npos) << line << script;
    // sbatch reads no further than the first command
    EXPECT_GT(script.find("\nprogram="), script.rfind("\n#SBATCH"));
  }
  EXPECT_EQ(call_for_tasks("/a/100%.job", {1, 2, 5}, options),
            (std::vector<std::string>{"sbatch",
                                      "--parsable",
                                      "--array=1-2,5%7",
                                      "--chdir=/a/100%.job",
                                      "--output=/a/100%%.job/logs/task-%a.log",
                                      "/a/100%.job/tasks.sh"}));
  EXPECT_EQ(call_for_collecting("/a.job", "12")[2], "--dependency=afterany:12");
}

TEST_F(BatchScripts, TakeNoOptionThatWouldBeALineOfItsOwn) {
  for (const auto& [member, value] : {std::pair{&SlurmOptions::partition, "a b"},
                                      {&SlurmOptions::time, "1\n#SBATCH --uid=0"},
                                      {&SlurmOptions::more, "--qos=a\nrm -r /"}}) {
    SlurmOptions options;
    options.*member = value;
    EXPECT_THROW(check_slurm_options(options), Error) << value;
  }
}

TEST(ShellLine, IsTakenApartByAShell) {
  const std::vector<std::string> words = {"-o", "a b", "it's", "$(x)", "", "--set", "a=1;b"};
  const ChildResult ran = run_child({"sh", "-c", "printf '%s\\n' " + shell_line(words)}, "");
  std::string lines;
  for (const std::string& word : words)
    lines += word + "\n";
  EXPECT_EQ(ran.out, lines);
}

}  // namespace
}  // namespace polhode
