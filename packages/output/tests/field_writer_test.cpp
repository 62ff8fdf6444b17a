#include "hawser/output/field_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "hawser/base/error.hpp"
#include "hawser/output/result_folder.hpp"
#include "sample.hpp"

namespace hawser {
namespace {

namespace fs = std::filesystem;

void write_samples(const Communicator& all, const std::string& folder) {
  for (const Grid& grid : {sample::strip(all), sample::cable(all)}) {
    FieldWriter writer(all, folder, grid);
    for (const int step : {0, 10, 20}) {
      const double time = 2.5 * step;
      writer.write(step, time, sample::coordinates(grid, time), sample::fields(grid, time));
    }
  }
}

TEST(FieldWriter, WritesWhatPythonReadsBack) {
  const Communicator all;
  const ResultFolder folder(all, "fields", ExistingResults::replace);
  write_samples(all, folder.path());
  // read_back.py knows the formulas of sample.hpp and compares every number.
  const std::string check =
      "/usr/bin/python3 " HAWSER_SOURCE_DIR "/packages/output/tests/read_back.py " + folder.path();
  int status = 0;
  all.on_root([&] { status = std::system(check.c_str()); });
  EXPECT_EQ(status, 0);
}

TEST(FieldWriter, StartsAfreshAndContinues) {
  const Communicator all;
  const ResultFolder folder(all, "continued", ExistingResults::replace);
  write_samples(all, folder.path());
  const Grid grid = sample::strip(all);
  FieldWriter continued(all, folder.path(), grid, 10);
  all.on_root([&] {
    EXPECT_TRUE(fs::exists("continued/flow-000010.h5"));
    EXPECT_FALSE(fs::exists("continued/flow-000020.h5"));
    EXPECT_TRUE(fs::exists("continued/cable-000020.h5")) << "the files of another grid";
  });
  continued.write(30, 75, sample::coordinates(grid, 75), sample::fields(grid, 75));
  all.on_root([&] {
    const std::string count = "test $(grep -c '<Time' continued/flow.xdmf) = 3";
    EXPECT_EQ(std::system(count.c_str()), 0);
  });
  FieldWriter afresh(all, folder.path(), grid);
  all.on_root([&] { EXPECT_FALSE(fs::exists("continued/flow-000000.xdmf")); });
}

TEST(FieldWriter, LeavesNothingUnfinished) {
  const Communicator all;
  const ResultFolder folder(all, "finished", ExistingResults::replace);
  write_samples(all, folder.path());
  all.on_root([] {
    for (const auto& file : fs::directory_iterator("finished")) {
      EXPECT_NE(file.path().extension(), ".unfinished") << file.path();
    }
  });
}

TEST(FieldWriter, NamesTheFolderItCannotWrite) {
  const Communicator all;
  const ResultFolder folder(all, "vanishing", ExistingResults::replace);
  const Grid grid = sample::strip(all);
  FieldWriter writer(all, folder.path(), grid);
  all.on_root([] { fs::remove_all("vanishing"); });
  EXPECT_THAT(
      [&] { writer.write(1, 0, sample::coordinates(grid, 0), {}); },
      testing::ThrowsMessage<OutputError>(testing::AllOf(
          testing::HasSubstr("vanishing/flow-000001.h5"), testing::HasSubstr("No such file"))));
}

}  // namespace
}  // namespace hawser
