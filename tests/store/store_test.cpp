// What the store keeps over a restart, byte for byte, and what it does about files that it cannot use.
#include "server/store/store.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "server/store/folder_lock.h"

namespace raywalk::store {
namespace {

class StoreTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "raywalk-store-XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  /// Files in the folder whose names begin so.
  int count_files(const std::string& beginning) const {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      count += entry.path().filename().string().starts_with(beginning);
    }
    return count;
  }

  std::filesystem::path folder;
};

JobRow job_named(const std::string& id) {
  JobRow job;
  job.id = id;
  job.kind = "benchmark";
  job.spec = "{}";
  job.state = "queued";
  job.created_at = "2026-01-01T00:00:00.000Z";
  return job;
}

TEST_F(StoreTest, KeepsEveryFieldOfAJob) {
  JobRow job = job_named("j1");
  job.spec = std::string("{\"name\": \"\xc3\xa9\"}\0\xff tail", 22);
  job.stage = "measuring";
  job.key = "a key";
  job.attempt = 3;
  job.version = u64{1} << 40;
  job.progress = 0.1;
  job.frames_done = 5;
  job.frames_total = 9;
  job.error = "";
  job.started_at = "s";
  job.ended_at = "e";
  Store(folder).save(job);
  Store store(folder);
  const std::vector<JobRow> jobs = store.jobs();
  ASSERT_EQ(jobs.size(), 1u);
  const JobRow& kept = jobs[0];
  EXPECT_EQ(kept.id, job.id);
  EXPECT_EQ(kept.kind, job.kind);
  EXPECT_EQ(kept.spec, job.spec);
  EXPECT_EQ(kept.state, job.state);
  EXPECT_EQ(kept.stage, job.stage);
  EXPECT_EQ(kept.key, job.key);
  EXPECT_EQ(kept.attempt, job.attempt);
  EXPECT_EQ(kept.version, job.version);
  EXPECT_EQ(kept.progress, job.progress);
  EXPECT_EQ(kept.frames_done, job.frames_done);
  EXPECT_EQ(kept.frames_total, job.frames_total);
  EXPECT_EQ(kept.error, job.error);
  EXPECT_EQ(kept.created_at, job.created_at);
  EXPECT_EQ(kept.started_at, job.started_at);
  EXPECT_EQ(kept.ended_at, job.ended_at);
  EXPECT_FALSE(kept.has_result);
}

TEST_F(StoreTest, KeepsTheOrderOfFirstSaving) {
  {
    Store store(folder);
    for (const char* id : {"b", "a", "c"}) store.save(job_named(id));
    JobRow again = job_named("b");
    again.state = "running";
    store.save(again);
  }
  Store store(folder);
  std::vector<std::string> ids, states;
  for (const JobRow& job : store.jobs()) {
    ids.push_back(job.id);
    states.push_back(job.state);
    EXPECT_EQ(job.error, std::nullopt);
  }
  EXPECT_EQ(ids, (std::vector<std::string>{"b", "a", "c"}));
  EXPECT_EQ(states, (std::vector<std::string>{"running", "queued", "queued"}));
}

TEST_F(StoreTest, KeepsTheBytesOfResults) {
  std::string json, csv(3'000'000, 'x');
  for (int i = 0; i < 100'000; ++i) json += static_cast<char>(i * 7919 >> 3);
  Store(folder).save(job_named("j1"), {json, csv});
  Store store(folder);
  EXPECT_TRUE(store.jobs().at(0).has_result);
  const std::optional<ResultRow> kept = store.result("j1");
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->json, json);
  EXPECT_EQ(kept->csv, csv);
  EXPECT_FALSE(store.result("j2"));
  store.save(job_named("j1"));
  EXPECT_TRUE(store.result("j1")) << "saving the job again keeps its result";
  store.forget_job("j1");
  EXPECT_FALSE(store.result("j1"));
  EXPECT_TRUE(store.jobs().empty());
}

TEST_F(StoreTest, KnowsACrashFromAnEnd) {
  EXPECT_FALSE(Store(folder).crashed_before()) << "nothing was before";
  EXPECT_FALSE(Store(folder).crashed_before()) << "one that never served did not crash";
  Store(folder).begin_session("cuda");
  EXPECT_TRUE(Store(folder).crashed_before());
  EXPECT_EQ(Store(folder).crashed_device(), "cuda");
  Store(folder).end_session();
  Store after(folder);
  EXPECT_FALSE(after.crashed_before());
  EXPECT_EQ(after.crashed_device(), "");
}

TEST_F(StoreTest, ResidentScenesAndStructures) {
  {
    Store store(folder);
    store.add_scene({"soup", 1000});
    store.add_scene({"city", std::nullopt});
    store.add_scene({"room", std::nullopt});
    store.add_structure({"soup.bvh", "soup", "bvh", "{\"leaf\":4}"});
    store.add_structure({"soup.grid", "soup", "grid", "{}"});
    store.add_structure({"city.bvh", "city", "bvh", "{}"});
    store.add_structure({"room.bvh", "room", "bvh", "{}"});
    store.add_structure({"mine.bvh", "mine", "bvh", "{}"});  // an upload's
    store.drop_structure("soup.grid");
    store.drop_scene("city");
    store.add_scene({"room", 77});
  }
  Store store(folder);
  const Resident resident = store.resident();
  ASSERT_EQ(resident.scenes.size(), 2u);
  EXPECT_EQ(resident.scenes[0].name, "soup");
  EXPECT_EQ(resident.scenes[0].triangles, 1000u);
  EXPECT_EQ(resident.scenes[1].name, "room");
  EXPECT_EQ(resident.scenes[1].triangles, 77u);
  ASSERT_EQ(resident.structures.size(), 1u);
  EXPECT_EQ(resident.structures[0].id, "soup.bvh");
  EXPECT_EQ(resident.structures[0].options, "{\"leaf\":4}");
  EXPECT_EQ(store.resident().structures.size(), 1u) << "reading leaves it there";
  store.forget_resident();
  const Resident rest = store.resident();
  EXPECT_TRUE(rest.scenes.empty());
  EXPECT_TRUE(rest.structures.empty());
}

TEST_F(StoreTest, AFileThatIsNoDatabaseIsMovedAside) {
  const std::string junk(10'000, 'j');
  std::ofstream(folder / "raywalk.db") << junk;
  Store store(folder);
  EXPECT_TRUE(store.jobs().empty());
  store.save(job_named("j1"));
  ASSERT_EQ(count_files("raywalk.db.aside-"), 1);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!entry.path().filename().string().starts_with("raywalk.db.aside-")) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), junk) << "what was there is kept";
  }
}

TEST_F(StoreTest, ADatabaseWithADamagedPageIsMovedAside) {
  {
    Store store(folder);
    for (int i = 0; i < 500; ++i) store.save(job_named("j" + std::to_string(i)), {std::string(500, 'r'), "c"});
  }
  {
    std::fstream file(folder / "raywalk.db", std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(4096);
    file << std::string(20 * 4096, '\x55');
  }
  Store store(folder);
  EXPECT_TRUE(store.jobs().empty());
  EXPECT_EQ(count_files("raywalk.db.aside-"), 1);
}

TEST_F(StoreTest, AnotherVersionIsMovedAside) {
  Store(folder).save(job_named("j1"));
  Database(folder / "raywalk.db").run("PRAGMA user_version = 99");
  Store store(folder);
  EXPECT_TRUE(store.jobs().empty());
  EXPECT_EQ(count_files("raywalk.db.aside-"), 1);
}

TEST_F(StoreTest, ATornLogLosesNothingThatCameBefore) {
  // What kill -9 leaves: a log that was never folded into the database, here with its last bytes missing.
  const std::filesystem::path copy = folder / "copy";
  std::filesystem::create_directory(copy);
  {
    Store store(folder);
    store.begin_session("cpu");
    store.save(job_named("j1"), {"json", "csv"});
    store.save(job_named("j2"));
    for (const char* file : {"raywalk.db", "raywalk.db-wal"}) {
      std::filesystem::copy_file(folder / file, copy / file);
    }
  }
  const std::filesystem::path log = copy / "raywalk.db-wal";
  std::filesystem::resize_file(log, std::filesystem::file_size(log) - 100);
  Store store(copy);
  ASSERT_EQ(store.jobs().size(), 1u);
  EXPECT_EQ(store.result("j1")->json, "json");
  EXPECT_TRUE(store.crashed_before());
}

TEST_F(StoreTest, AFolderThatCannotBeWrittenIsAnError) {
  EXPECT_THROW(Store(folder / "nothing"), DatabaseError);
}

TEST_F(StoreTest, OneHolderAFolder) {
  {
    const FolderLock first(folder);
    try {
      const FolderLock second(folder);
      FAIL() << "the folder should be held";
    } catch (const FolderError& e) {
      EXPECT_NE(std::string(e.what()).find("Another daemon uses the state folder"), std::string::npos) << e.what();
    }
  }
  EXPECT_NO_THROW(FolderLock{folder});
  EXPECT_THROW(FolderLock(folder / "nothing"), FolderError);
}

}  // namespace
}  // namespace raywalk::store
