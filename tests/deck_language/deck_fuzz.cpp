// Mutants of the shipped decks through everything that reads decks: each is understood or refused
// with a place, none crashes, none takes long. Deterministic: mutant n is the same every time.
//
//   deck_fuzz FOLDER_WITH_DECKS MUTANTS [FIRST]
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/deck/read_deck.hpp"
#include "language.hpp"
#include "mutator.hpp"

namespace {

using namespace hawser;
using Files = std::map<std::string, std::string>;

constexpr double longest_seconds = 10;

Files read_decks(const std::string& folder) {
  Files files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".xml") continue;
    std::ifstream stream(entry.path());
    std::stringstream text;
    text << stream.rdbuf();
    files[entry.path().lexically_normal().string()] = text.str();
  }
  return files;
}

/// A part is an attribute's value.
const MutantParts parts = {{"nan",
                            "1e400",
                            "-1e-400",
                            "99999999999999",
                            "0x10",
                            "\"",
                            "<",
                            ">",
                            "/>",
                            "&",
                            "&#0;",
                            "&lt;",
                            "<!--",
                            "-->",
                            "<![CDATA[",
                            "<?x",
                            "<!DOCTYPE a>",
                            "((((",
                            "))))",
                            ";",
                            ",",
                            "{1,2}",
                            "^",
                            "^^",
                            "1 kn",
                            " m/s",
                            "1/0",
                            "sqrt(-1)",
                            "t",
                            "x",
                            "current",
                            "pi",
                            "\xff\xfe",
                            "\xc3",
                            "\0x",
                            "\n\n",
                            "extends=\"base.xml\"",
                            "remove=\"true\"",
                            "name=\"a\"",
                            " ",
                            "e",
                            "--",
                            "'",
                            "=",
                            "[",
                            "]",
                            "<parameter name=\"p\" value=\"p\"/>",
                            "<hawser>",
                            "</hawser>",
                            "<cable/>",
                            "%",
                            "2 (m",
                            "m^99"},
                           [](const std::string& text, std::size_t from) {
                             const std::size_t begin = text.find("=\"", from);
                             if (begin == std::string::npos)
                               return std::pair(std::size_t{0}, std::size_t{0});
                             const std::size_t end = text.find('"', begin + 2);
                             return std::pair(begin + 2,
                                              end == std::string::npos ? 0 : end - begin - 2);
                           }};

/// Everything that `hawser check` does; the complaint, or "".
std::string fault_of(const Files& files, const std::string& file,
                     const std::vector<DeckChange>& changes) {
  const DeckFiles source = [&](const std::string& name) {
    const auto found = files.find(std::filesystem::path(name).lexically_normal().string());
    return found == files.end() ? std::nullopt : std::optional<std::string>(found->second);
  };
  try {
    Diagnostics diagnostics;
    const Deck deck = read_deck(source, file, changes, language(), diagnostics);
    const RunDeck run = RunDeck::spec().read(deck.root, diagnostics);
    for (const DeckNode& node : run.modules.modules)
      if (is_known_child(node, "modules", known().modules.tags(), diagnostics))
        known().modules.find(node.tag)->make(node, {run.mesh.dimension()}, diagnostics);
    known().reports.read(run.reports, RunDeck::spec().node_spec(), diagnostics);
    known().reports.read(run.output.reports, OutputDeck::spec().node_spec(), diagnostics);
    if (diagnostics.ok()) {
      // What is accepted must survive being written and read again, as in a checkpoint.
      const std::string resolved = resolved_deck(deck.root, language());
      Diagnostics again;
      RunDeck::spec().read(parse_deck(resolved, "resolved.xml", again).root, again);
      if (!again.ok()) {
        std::printf("the resolved deck is refused: %s\n%s", again.error_text().c_str(),
                    resolved.c_str());
        std::exit(1);
      }
    }
    return diagnostics.error_text();
  } catch (const DeckError& error) {
    return error.what();
  }
}

/// "file.xml:3:9: sentence", "file.xml: sentence" for a fault of the whole, "--set a=b: sentence".
bool names_place(const std::string& line) {
  if (line.compare(0, 6, "--set ") == 0) return line.find(": ") != std::string::npos;
  std::size_t at = line.find(".xml:");
  if (at == std::string::npos) return false;
  at += 5;
  if (line[at] == ' ') return true;
  int line_number = 0, column = 0;
  return std::sscanf(line.c_str() + at, "%d:%d: ", &line_number, &column) == 2 && line_number > 0;
}

bool names_places(const std::string& faults) {
  std::istringstream lines(faults);
  for (std::string line; std::getline(lines, line);)
    if (!names_place(line)) return false;
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const Files files = read_decks(argv[1]);
  const unsigned count = static_cast<unsigned>(std::atoi(argv[2]));
  const unsigned first = argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 0;
  unsigned refused = 0;
  double slowest = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    Mutator mutator(seed, parts);
    Files mutants = files;
    const auto at = [&](std::size_t n) { return std::next(mutants.begin(), static_cast<long>(n)); };
    const std::string file = at(mutator.below(mutants.size()))->first;
    mutants[file] = mutator.mutated(mutants[file]);
    // A mutant that others extend is read through one of them half of the time.
    const std::string entry =
        mutator.below(2) == 0 ? file : at(mutator.below(mutants.size()))->first;
    std::vector<DeckChange> changes;
    if (mutator.below(4) == 0)
      changes.push_back(
          {mutator.mutated("conditions/prescribe[tow]/value"), mutator.mutated("0; 2 kn")});
    const auto start = std::chrono::steady_clock::now();
    const std::string fault = fault_of(mutants, entry, changes);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    slowest = std::max(slowest, seconds.count());
    refused += fault.empty() ? 0 : 1;
    if (names_places(fault) && seconds.count() < longest_seconds) continue;
    std::printf("mutant %u of %s, %.1f s: %s\n%s\n", seed, file.c_str(), seconds.count(),
                fault.c_str(), mutants[file].c_str());
    return 1;
  }
  std::printf(
      "%u mutants of %zu decks: %u refused with their places, %u accepted; slowest %.3f s\n", count,
      files.size(), refused, count - refused, slowest);
  return refused > count / 4 ? 0 : 1;
}
