#pragma once
// A measured number that doc/verification.md tells: record(...) beside the EXPECT that judges it.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace hawser {

struct Figure {
  std::string name;           ///< lower case with '.' and '_', first the test: "moving_mesh.shear"
  std::string section;        ///< heading on the page: "Invariants", "Structures", ...
  std::string what;           ///< one clause for people
  std::string unit;           ///< "1" when there is none
  double value = 0;           ///< as measured in this run
  double reference = 0;       ///< as it should be
  double tolerance = 0;       ///< absolute, in the unit
  std::string source;         ///< where reference and tolerance come from
  const char* is = "within";  ///< of the reference: or "at-least" it less, "at-most" it plus, the
                              ///< tolerance
};

/// Writes <folder>/<name>.json. The folder is in the environment variable HAWSER_FIGURES, which
/// ctest sets for one number of ranks; elsewhere nothing is written. On rank 0 only.
inline void record(const Figure& figure) {
  const double above = figure.value - figure.reference;
  EXPECT_TRUE(std::abs(above) <= figure.tolerance ||
              (figure.is == std::string("at-least") && above > 0) ||
              (figure.is == std::string("at-most") && above < 0))
      << figure.name << " = " << figure.value << " " << figure.unit;
  const char* const folder = std::getenv("HAWSER_FIGURES");
  const char* const rank = std::getenv("OMPI_COMM_WORLD_RANK");
  if (folder == nullptr || (rank != nullptr && std::string(rank) != "0")) return;
  const nlohmann::ordered_json json = {
      {"name", figure.name},
      {"section", figure.section},
      {"what", figure.what},
      {"unit", figure.unit},
      {"value", figure.value},
      {"reference", figure.reference},
      {"tolerance", figure.tolerance},
      {"is", figure.is},
      {"source", figure.source},
      {"command", "ctest --test-dir build -R '^" HAWSER_TEST_NAME "[.]'"}};
  std::filesystem::create_directories(folder);
  std::ofstream file(std::filesystem::path(folder) / (figure.name + ".json"));
  file << json.dump(1) << '\n';
  EXPECT_TRUE(file.flush().good()) << "cannot write a figure into " << folder;
}

}  // namespace hawser
