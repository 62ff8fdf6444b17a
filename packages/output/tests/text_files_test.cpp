#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/output/history.hpp"
#include "hawser/output/result_folder.hpp"
#include "hawser/output/summary.hpp"

namespace hawser {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::string contents(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(History, NamesQuantitiesWithTheirUnitLast) {
  EXPECT_EQ(quantity_name({"end_error", "m"}), "end_error_m");
  EXPECT_EQ(quantity_name({"tow_force", "N/m"}), "tow_force_n_per_m");
  EXPECT_EQ(quantity_name({"rate", "1/s"}), "rate_1_per_s");
  EXPECT_EQ(quantity_name({"area", "m^2"}), "area_m2");
  EXPECT_EQ(quantity_name({"mesh_quality_min", ""}), "mesh_quality_min");
}

TEST(History, IsReadableAtAnyTimeAndContinues) {
  const Communicator all;
  const std::vector<Column> columns = {{"t", "s"}, {"end_error", "m"}};
  History history(all, "history.csv", columns);
  history.append({0, 0.1});
  history.append({10, 1.0 / 3.0});
  history.append({20, 2e-20});
  all.on_root([] {
    EXPECT_EQ(contents("history.csv"), "t_s,end_error_m\n0,0.1\n10,0.333333333333\n20,2e-20\n");
    std::ofstream("history.csv", std::ios::app) << "30,1.";  // as a kill may leave it
  });
  History continued(all, "history.csv", columns, 10.0);
  continued.append({15, 1});
  all.on_root([] {
    EXPECT_EQ(contents("history.csv"), "t_s,end_error_m\n0,0.1\n10,0.333333333333\n15,1\n");
  });
}

TEST(Summary, KeepsOrderAndDigits) {
  Summary summary;
  summary.set("end_error_m", 0.1);
  summary.set("steps", 270);
  summary.set("steady", true);
  summary.object("timings").set("wall_s", 12.5);
  summary.set("deck", "case \"2\"");
  summary.set("lost", std::nan(""));
  summary.set("end_error_m", 154.3);
  EXPECT_EQ(summary.number("end_error_m"), 154.3);
  EXPECT_EQ(summary.number("steps"), 270.0);
  EXPECT_FALSE(summary.number("deck").has_value());
  EXPECT_EQ(summary.json(),
            "{\n  \"end_error_m\": 154.3,\n  \"steps\": 270,\n  \"steady\": true,\n"
            "  \"timings\": {\n    \"wall_s\": 12.5\n  },\n  \"deck\": \"case \\\"2\\\"\",\n"
            "  \"lost\": null\n}\n");
  const Communicator all;
  summary.write(all, "summary.json");
  all.on_root([&] { EXPECT_EQ(contents("summary.json"), summary.json()); });
}

TEST(ResultFolder, RefusesAnotherRunUnlessForced) {
  const Communicator all;
  all.on_root([] { std::filesystem::remove_all("results"); });
  const std::string path = "results/case/one";
  const auto file = [&](const char* name) { return path + "/" + name; };
  const auto write = [&](const char* name, const char* text) {
    all.on_root([&] { std::ofstream(file(name)) << text; });
  };
  EXPECT_NO_THROW(ResultFolder(all, path));
  EXPECT_NO_THROW(ResultFolder(all, path)) << "nothing in it";
  const auto expect_refused = [&](const std::string& sentence) {
    EXPECT_THAT([&] { ResultFolder(all, path); },
                ThrowsMessage<OutputError>(HasSubstr(path + sentence)));
  };
  write("history.csv", "t\n");
  expect_refused(" holds an unfinished run, without a checkpoint");
  write("checkpoint.h5", "");
  expect_refused(" holds an unfinished run; go on with: hawser restart " + path + "/checkpoint.h5");
  write("summary.json", "{}");
  expect_refused(" holds the results of another run");

  const auto there = [&](const char* name) { return std::filesystem::exists(file(name)); };
  EXPECT_NO_THROW(ResultFolder(all, path, ExistingResults::go_on));
  all.on_root([&] {
    EXPECT_FALSE(there("summary.json")) << "unfinished again";
    EXPECT_TRUE(there("checkpoint.h5"));
  });
  EXPECT_NO_THROW(ResultFolder(all, path, ExistingResults::replace));
  all.on_root(
      [&] { EXPECT_FALSE(there("checkpoint.h5")) << "it would be taken for one of the new run"; });
}

TEST(ResultFolder, HasOneRunAtATime) {
  const Communicator all;
  const ResultFolder folder(all, "results/locked", ExistingResults::replace);
  for (const ExistingResults existing :
       {ExistingResults::keep, ExistingResults::replace, ExistingResults::go_on})
    EXPECT_THAT(
        [&] { ResultFolder(all, "results/locked", existing); },
        ThrowsMessage<OutputError>(HasSubstr("results/locked is in use by a run: process")));
}

TEST(ResultFolder, SaysWhyItCannotBeWritten) {
  const Communicator all;
  all.on_root([] { std::ofstream("a_file") << "text"; });
  EXPECT_THAT([&] { ResultFolder(all, "a_file/x"); },
              ThrowsMessage<OutputError>("cannot make the folder a_file/x: Not a directory"));
  EXPECT_THROW(ResultFolder(all, "a_file"), OutputError);
}

}  // namespace
}  // namespace hawser
