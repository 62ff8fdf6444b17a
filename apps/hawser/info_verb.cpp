// What a result folder or a checkpoint holds, and where it comes from.
#include <nlohmann/json.hpp>

#include <cstdio>

#include "hawser/output/result_contents.hpp"
#include "verb.hpp"

namespace hawser::program {
namespace {

using Json = nlohmann::ordered_json;

void print(const char* what, const std::string& text) {
  std::printf("%-12s%s\n", what, text.c_str());
}

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string plain(const Json& value) {
  if (value.is_number_float()) return short_number(value.get<double>());
  return value.is_string() ? value.get<std::string>() : value.dump();
}

void print_provenance(const Json& from) {
  const auto word = [&](const char* key) {
    return from.contains(key) ? plain(from[key]) : std::string("?");
  };
  print("made by", "hawser " + word("hawser_version") + " (" + word("git_revision") + ") on " +
                       word("ranks") + " rank(s) of " + word("host") + ", " + word("date_utc"));
  print("",
        word("compiler") + ", Trilinos " + word("trilinos_version") + ", " + word("mpi_library"));
}

void print_summary(const Json& summary) {
  for (const auto& [key, value] : summary.items()) {
    if (value.is_object() || key == "title") continue;
    std::printf("  %-40s%s\n", key.c_str(), plain(value).c_str());
  }
  if (!summary.contains("expectations")) return;
  for (const auto& [quantity, expectation] : summary["expectations"].items())
    std::printf("  expected %s = %s within %s: %s\n", quantity.c_str(),
                plain(expectation["expected"]).c_str(), plain(expectation["within"]).c_str(),
                expectation["holds"].get<bool>() ? "holds" : "FAILS");
}

void print_checkpoint(const CheckpointHeader& header) {
  print("checkpoint", "step " + std::to_string(header.step) + ", t = " + short_number(header.time) +
                          " s, deck " + header.texts.at("deck_file"));
}

void print_grid(const GridContents& grid) {
  std::string fields;
  for (const auto& [name, unit] : grid.fields)
    fields += (fields.empty() ? "" : ", ") + name + (unit.empty() ? "" : " (" + unit + ")");
  print("fields", grid.name + ": " + std::to_string(grid.outputs) +
                      " output(s), t = " + short_number(grid.first_time) + " to " +
                      short_number(grid.last_time) + " s: " + fields);
}

void print_table(const TableContents& table) {
  print("table", table.file + ": " + std::to_string(table.rows) +
                     " rows to t = " + short_number(table.last_time) + " s, " +
                     std::to_string(table.columns.size()) + " columns");
}

void print_contents(const std::string& path, const ResultContents& contents) {
  const Json summary = contents.summary ? Json::parse(*contents.summary, nullptr, false) : Json();
  const bool readable = summary.is_object();
  const char* const kind = readable                  ? "a finished run"
                           : contents.tables.empty() ? "a checkpoint"
                                                     : "an unfinished run";
  std::printf("%s: %s\n", path.c_str(), kind);
  if (readable && summary.contains("title")) print("title", plain(summary["title"]));
  if (readable && summary.contains("provenance")) print_provenance(summary["provenance"]);
  if (contents.checkpoint) {
    print_checkpoint(*contents.checkpoint);
    const auto provenance = contents.checkpoint->texts.find("provenance");
    if (!readable && provenance != contents.checkpoint->texts.end())
      print_provenance(Json::parse(provenance->second));
  }
  for (const GridContents& grid : contents.grids)
    print_grid(grid);
  for (const TableContents& table : contents.tables)
    print_table(table);
  if (readable) print_summary(summary);
}

}  // namespace

std::vector<Verb> info_verbs(CLI::App& app) {
  auto* verb = app.add_subcommand("info", "say what a result folder or a checkpoint holds");
  verb->footer("Example: hawser info results/case_02_quick");
  const auto path = std::make_shared<std::string>();
  verb->add_option("result", *path, "result folder, or checkpoint.h5")->required();
  return {{verb, OnRanks([path](const Environment& environment) {
             const Communicator& world = environment.communicator();
             const ResultContents contents = read_contents(world, *path);
             if (world.is_root()) print_contents(*path, contents);
             return 0;
           })}};
}

}  // namespace hawser::program
