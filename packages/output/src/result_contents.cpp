#include "hawser/output/result_contents.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "hawser/base/error.hpp"
#include "src/hdf5_file.hpp"

namespace hawser {
namespace {

namespace fs = std::filesystem;

/// Steps of every grid there are files of, in ascending order.
std::map<std::string, std::vector<int>> written_steps(const std::string& folder) {
  std::map<std::string, std::vector<int>> steps;
  const std::regex name("(.+)-([0-9]{6,})\\.h5");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::smatch parts;
    const std::string file = entry.path().filename();
    if (std::regex_match(file, parts, name)) steps[parts[1]].push_back(std::stoi(parts[2]));
  }
  for (auto& [grid, numbers] : steps)
    std::sort(numbers.begin(), numbers.end());
  return steps;
}

GridContents read_grid(const Communicator& communicator, const std::string& folder,
                       const std::string& name, const std::vector<int>& steps) {
  const auto file = [&](int step) {
    const std::string number = std::to_string(step);
    const std::string zeros(number.size() < 6 ? 6 - number.size() : 0, '0');
    return Hdf5File::open(communicator, folder + "/" + name + "-" + zeros + number + ".h5");
  };
  GridContents grid{name, static_cast<int>(steps.size()), steps.front(), steps.back(), 0, 0, {}};
  grid.first_time = file(steps.front()).number("/", "time");
  const Hdf5File last = file(steps.back());
  grid.last_time = last.number("/", "time");
  for (const std::string& field : last.names("fields"))
    grid.fields.emplace_back(field, last.text("fields/" + field, "unit"));
  return grid;
}

TableContents read_table(const std::string& path) {
  TableContents table{fs::path(path).filename(), {}, 0, 0};
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::istringstream header(line);
  for (std::string column; std::getline(header, column, ',');)
    table.columns.push_back(column);
  while (std::getline(file, line) && !file.eof()) {
    ++table.rows;
    table.last_time = std::strtod(line.c_str(), nullptr);
  }
  return table;
}

/// Every table over time, history.csv first.
std::vector<TableContents> read_tables(const std::string& folder) {
  std::vector<TableContents> tables;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".csv") continue;
    TableContents table = read_table(entry.path());
    if (!table.columns.empty() && table.columns.front() == "t_s") tables.push_back(table);
  }
  std::sort(tables.begin(), tables.end(), [](const TableContents& a, const TableContents& b) {
    const auto place = [](const TableContents& table) {
      return std::pair(table.file != "history.csv", table.file);
    };
    return place(a) < place(b);
  });
  return tables;
}

}  // namespace

ResultContents read_contents(const Communicator& communicator, const std::string& path) {
  ResultContents contents;
  communicator.on_root([&] {
    std::error_code none;
    if (!fs::exists(path, none))
      throw OutputError(path + " is not there; give a result folder or a checkpoint");
  });
  const bool is_folder = communicator.any(communicator.is_root() && fs::is_directory(path));
  if (!is_folder) {
    contents.checkpoint = CheckpointReader(communicator, path).header();
    return contents;
  }
  const auto there = [&](const char* name) {
    return communicator.any(communicator.is_root() && fs::exists(path + "/" + name));
  };
  if (there("checkpoint.h5"))
    contents.checkpoint = CheckpointReader(communicator, path + "/checkpoint.h5").header();
  contents.tables = read_tables(path);
  if (there("summary.json")) {
    std::ostringstream text;
    text << std::ifstream(path + "/summary.json").rdbuf();
    contents.summary = text.str();
  }
  for (const auto& [grid, steps] : written_steps(path))
    contents.grids.push_back(read_grid(communicator, path, grid, steps));
  if (!contents.summary && !contents.checkpoint && contents.tables.empty())
    throw OutputError(path +
                      " is no result folder: it has no summary.json, checkpoint.h5 or history.csv");
  return contents;
}

}  // namespace hawser
