// Any bytes as a MSH file, read, numbered, connected and audited as rank 0 does it. The first byte
// says what the deck says beside the file. A file is refused with its line or byte, or, where it is
// well formed and the mesh is no good, with a sentence about the mesh.
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>

#include "fuzz.hpp"
#include "hawser/base/error.hpp"
#include "hawser/mesh/mesh_audit.hpp"
#include "mesh/src/whole_mesh.hpp"
#include "mesh/tests/binary_mesh.hpp"

namespace {

using namespace hawser;

MeshOptions asked_for(std::uint8_t choice) {
  MeshOptions options;
  if (choice & 1U) options.dimension = 3;
  if (choice & 2U) options.slits = {"cable"};
  if (choice & 4U) options.domains = {Domain("water"), Domain("cable"), Domain::patches("cable")};
  if (choice & 8U) options.domains.push_back(Domain::facets("wall"));
  if (choice & 16U) options.apart = {"cable"};
  options.open_boundary = (choice & 32U) != 0;
  return options;
}

/// A file of that content that is in memory alone.
class Content {
 public:
  explicit Content(const std::string& bytes) : file_(memfd_create("mesh", 0)) {
    if (file_ < 0 || write(file_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
      broken("no memory for the file");
  }
  ~Content() { close(file_); }
  Content(const Content&) = delete;
  Content& operator=(const Content&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

bool names_the_file(const std::string& sentence, const std::string& path) {
  return sentence.compare(0, path.size() + 1, path + ":") == 0;
}

}  // namespace

std::vector<std::string> good_inputs() {
  MeshText text = grid(3, 2);
  text.groups.push_back(line("cable", {1, 5, 9}));
  text.groups.push_back({"corner", 0, {{0}}});
  MeshText lines;
  lines.nodes = {{0, 0}, {1, 0}, {2, 0}, {1, 1}};
  lines.groups = {line("cable", {0, 1, 2}), {"end", 0, {{2}}}};
  const std::string part =
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"water\"\n$EndPhysicalNames\n"
      "$Entities\n0 0 1 0\n1 0 0 0 1 1 0 1 1 0\n$EndEntities\n"
      "$PartitionedEntities\n2\n0\n0 0 2 0\n1 2 1 1 1 0 0 0 1 1 0 1 1 0\n2 2 1 1 2 0 0 0 1 1 0 1 1 "
      "0\n"
      "$EndPartitionedEntities\n$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
      "$EndNodes\n$Elements\n2 2 1 2\n2 1 2 1\n1 1 2 3\n2 2 2 1\n2 1 3 4\n$EndElements\n";
  std::vector<std::string> inputs;
  for (const char* const choice : {"\x20", "\x26", "\x3d", "\x2e", "\x07"})
    for (const std::string& file :
         {text.in_format("4.1"), text.in_format("2.2"), binary(text, "4.1"), binary(text, "2.2"),
          lines.in_format("4.1"), part})
      inputs.push_back(choice + file);
  return inputs;
}

Answer answer_to(const std::string& input) {
  if (input.empty()) return Answer::refused;
  const Content content(input.substr(1));
  MeshOptions options = asked_for(static_cast<std::uint8_t>(input[0]));
  options.file = content.path();
  try {
    Mesh mesh = check_and_number(read_msh(options.file), options.dimension);
    try {
      add_topology(mesh, options);
      for (const MeshFinding& finding : audit(mesh, options))
        if (finding.sentence.empty()) broken("a finding without a sentence");
    } catch (const MeshError& error) {
      if (std::strlen(error.what()) == 0) broken("refused without a sentence");
      return Answer::refused;
    }
  } catch (const MeshError& error) {
    if (!names_the_file(error.what(), options.file))
      broken(std::string("refused without a place: ") + error.what());
    return Answer::refused;
  }
  return Answer::read;
}
