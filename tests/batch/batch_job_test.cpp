// SPDX-License-Identifier: MIT
#include "batch/batch_job.h"

#include "base/error.h"
#include "batch/job_folders.h"
#include "support/expect_error.h"

namespace polhode {
namespace {

using test::TemporaryFolder;

TEST(BatchJob, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  BatchJob job = test::small_job(folder);
  job.arguments = {"a b.toml", "--set", "title=\"'\n\xc3\xa9\""};
  job.submissions = {{"12", "13", {1, 2, 3, 4}}, {"", "15", {}}, {"16", "17", {2, 4}}};
  const std::filesystem::path place = test::make_job_folder(job);
  const BatchJob read = read_job(place);
  EXPECT_EQ(read.arguments, job.arguments);
  EXPECT_EQ(read.hash, job.hash);
  EXPECT_EQ(read.tasks, 4);
  ASSERT_EQ(read.submissions.size(), 3U);
  EXPECT_EQ(read.submissions[0].tasks, (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(read.submissions[1].collecting, "15");
  EXPECT_EQ(read.submissions[2].tasks, (std::vector<int>{2, 4}));
}

TEST(BatchJob, IsFoundByItsFolderOrItsOutput) {
  const TemporaryFolder folder;
  const std::filesystem::path place = test::make_job_folder(test::small_job(folder));
  EXPECT_EQ(place, folder / "maps.job");
  EXPECT_EQ(find_job(place), place);
  EXPECT_EQ(find_job(folder / "maps"), place);
  EXPECT_EQ(find_job(folder / "maps/"), place);
  EXPECT_THROW(find_job(folder / "map"), Error);
}

TEST(BatchJob, ThatIsNoneIsToldWithItsFile) {
  const TemporaryFolder folder;
  const std::filesystem::path place = test::make_job_folder(test::small_job(folder));
  // whole, but for its number of tasks
  const std::string good = test::read_text(place / "job.json");
  const std::size_t tasks = good.find("\"tasks\": ") + 9;
  std::vector<std::string> texts = {"", "{", "[]", R"({"hash": 3})"};
  for (const char* number : {"-1", "0", "2147483647", "1e300"})
    texts.push_back(good.substr(0, tasks) + number + good.substr(good.find(',', tasks)));
  for (const std::string& text : texts) {
    test::write_text(place / "job.json", text);
    try {
      read_job(place);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.fault(), Fault::input);
      EXPECT_EQ(error.place().file, place / "job.json");
    }
  }
}

TEST(BatchJob, TakesOnlyUtf8) {
  const TemporaryFolder folder;
  BatchJob job = test::small_job(folder);
  job.arguments.emplace_back("\xff.toml");
  EXPECT_THROW(test::make_job_folder(job), Error);
}

TEST(Ranges, AreWrittenAndReadAsSlurmDoes) {
  EXPECT_EQ(ranges_of({1, 2, 3, 7, 9, 10}), "1-3,7,9-10");
  EXPECT_EQ(ranges_of({}), "");
  EXPECT_EQ(numbers_in("1-3,7%2"), (std::vector<int>{1, 2, 3, 7}));
  EXPECT_EQ(numbers_in("N/A"), (std::vector<int>{}));
  EXPECT_EQ(numbers_in("1-2147483647,-5,4"), (std::vector<int>{4}));
  // a record that names the same tasks again and again fills no memory
  std::string often;
  for (int i = 0; i < 1000; ++i)
    often += "1-100000,";
  EXPECT_EQ(numbers_in(often).size(), 100'000U);
}

TEST(MissingTasks, AreThoseWithoutAMark) {
  const TemporaryFolder folder;
  const BatchJob job = test::small_job(folder);
  const std::filesystem::path place = test::make_job_folder(job);
  test::write_text(mark_of_task(place, 2, "done"), "");
  test::write_text(mark_of_task(place, 3, "failed"), "1\n");
  EXPECT_EQ(missing_tasks(place, job), (std::vector<int>{1, 3, 4}));
}

}  // namespace
}  // namespace polhode
