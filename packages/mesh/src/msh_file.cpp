#include "msh_file.hpp"

#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

#include "line_scanner.hpp"

namespace hawser {
namespace {

// gmsh's numbers of the element types that Hawser reads. One more shape is one more case here.
std::optional<CellShape> shape_of(long long type) {
  switch (type) {
    case 15: return CellShape::point;
    case 1: return CellShape::line;
    case 2: return CellShape::triangle;
    default: return std::nullopt;
  }
}

std::string type_name(long long type) {
  switch (type) {
    case 3: return "a quadrilateral";
    case 4: return "a tetrahedron";
    case 8: return "a second-order line";
    case 9: return "a second-order triangle";
    default: return "of gmsh's type " + std::to_string(type);
  }
}

class MshReader {
 public:
  explicit MshReader(const std::string& path) : in_(path) { file_.path = path; }

  MshFile read() {
    in_.next("$MeshFormat");
    if (in_.word("$MeshFormat") != "$MeshFormat") in_.fail("expected $MeshFormat: no MSH file");
    read_format();
    close("$MeshFormat");
    while (in_.next()) {
      const std::string section(in_.word("a section"));
      if (section[0] != '$') in_.fail("expected a section such as $Nodes, found '" + section + "'");
      read_section(section);
      close(section);
    }
    if (file_.nodes.empty()) in_.fail("the file has no nodes");
    if (file_.elements.empty()) in_.fail("no element belongs to a physical group");
    return std::move(file_);
  }

 private:
  void read_format() {
    in_.next("the format version");
    const std::string version(in_.word("the format version"));
    if (version != "2.2" && version != "4.1") {
      in_.fail("MSH format " + version + " is not read; write 4.1 or 2.2 (Mesh.MshFileVersion)");
    }
    version4_ = version == "4.1";
    if (in_.integer("the file type") != 0) {
      in_.fail("the file is binary; write it as ASCII (Mesh.Binary = 0)");
    }
  }

  void read_section(const std::string& section) {
    if (section == "$PhysicalNames") {
      read_names();
    } else if (section == "$Entities" && version4_) {
      read_entities();
    } else if (section == "$Nodes") {
      version4_ ? read_nodes4() : read_nodes2();
    } else if (section == "$Elements") {
      version4_ ? read_elements4() : read_elements2();
    } else {
      skip_to_ = "$End" + section.substr(1);
    }
  }

  void close(const std::string& section) {
    const std::string end = "$End" + section.substr(1);
    in_.next(end);
    std::string found(in_.word(end));
    if (skip_to_ == end) {
      for (; found != end; found = in_.word(end))
        in_.next(end);
    }
    skip_to_.clear();
    if (found != end) in_.fail("expected " + end + ", found '" + found + "'");
  }

  long long counted(const std::string& what) {
    in_.next("the number of " + what);
    return in_.count("the number of " + what);
  }

  void read_names() {
    for (auto n = counted("physical names"); n > 0; --n) {
      in_.next("a physical name");
      MshGroup group;
      group.dimension = static_cast<int>(in_.integer("a dimension"));
      group.tag = in_.integer("a physical number");
      group.name = in_.quoted("a physical name");
      if (group.name.empty() || group.name.find('/') != std::string::npos) {
        in_.fail("the name '" + group.name + "' of a physical group is empty or holds a slash");
      }
      for (const auto& other : file_.groups) {
        if (other.name == group.name)
          in_.fail("two physical groups are named '" + group.name + "'");
      }
      const std::pair key(group.dimension, group.tag);
      if (!groups_.emplace(key, static_cast<int>(file_.groups.size())).second) {
        in_.fail("the physical group of '" + group.name + "' has another name already");
      }
      file_.groups.push_back(group);
    }
  }

  void read_entities() {
    in_.next("the numbers of entities");
    std::array<long long, 4> counts;
    for (auto& count : counts)
      count = in_.count("a number of entities");
    for (int dimension = 0; dimension < 4; ++dimension) {
      for (auto n = counts[static_cast<std::size_t>(dimension)]; n > 0; --n) {
        in_.next("an entity");
        auto& tags = entities_[{dimension, in_.integer("an entity's number")}];
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k)
          in_.real("a coordinate");
        tags.resize(static_cast<std::size_t>(in_.count("the number of physical groups")));
        // gmsh writes a negative number for a curve that its group takes backwards
        for (auto& tag : tags)
          tag = std::abs(in_.integer("a physical number"));
      }
    }
  }

  void read_position(MshNode& node) {
    node.line = in_.line();
    for (auto& x : node.position)
      x = in_.real("a coordinate");
  }

  void read_nodes2() {
    for (auto n = counted("nodes"); n > 0; --n) {
      in_.next("a node");
      MshNode node{};
      node.tag = in_.integer("a node number");
      read_position(node);
      in_.end("the node's coordinates");
      file_.nodes.push_back(node);
    }
  }

  void read_nodes4() {
    for (auto blocks = counted("node blocks"); blocks > 0; --blocks) {
      in_.next("a block of nodes");
      in_.integer("a dimension");
      in_.integer("an entity's number");
      in_.integer("0 or 1");
      const auto count = in_.count("the number of nodes in the block");
      const auto first = file_.nodes.size();
      for (long long k = 0; k < count; ++k) {
        in_.next("a node number");
        file_.nodes.push_back({in_.integer("a node number"), 0, {}});
      }
      for (auto node = first; node < file_.nodes.size(); ++node) {
        in_.next("a node's coordinates");
        read_position(file_.nodes[node]);  // parametric coordinates may follow
      }
    }
  }

  void read_elements2() {
    for (auto n = counted("elements"); n > 0; --n) {
      in_.next("an element");
      const auto tag = in_.integer("an element number");
      const auto type = in_.integer("an element type");
      std::vector<long long> groups;
      for (auto tags = in_.count("the number of tags"), k = 0LL; k < tags; ++k) {
        const auto value = in_.integer("a tag");
        if (k == 0 && value != 0) groups.push_back(std::abs(value));  // the others are gmsh's own
      }
      read_element(tag, type, groups);
    }
  }

  void read_elements4() {
    for (auto blocks = counted("element blocks"); blocks > 0; --blocks) {
      in_.next("a block of elements");
      const auto dimension = static_cast<int>(in_.integer("a dimension"));
      const auto entity = in_.integer("an entity's number");
      const auto type = in_.integer("an element type");
      const auto count = in_.count("the number of elements in the block");
      const auto groups = entities_.find({dimension, entity});
      if (groups == entities_.end()) {
        in_.fail("$Entities has no entity " + std::to_string(entity) + " of dimension " +
                 std::to_string(dimension));
      }
      for (long long k = 0; k < count; ++k) {
        in_.next("an element");
        const auto tag = in_.integer("an element number");
        read_element(tag, type, groups->second);
      }
    }
  }

  void read_element(long long tag, long long type, const std::vector<long long>& groups) {
    if (groups.empty()) return;
    const auto name = "element " + std::to_string(tag);
    const auto shape = shape_of(type);
    if (!shape) {
      in_.fail(name + " is " + type_name(type) +
               "; only points, lines and triangles of first order "
               "are read");
    }
    const int dimension = traits(*shape).dimension;
    MshElement element{tag, in_.line(), *shape, 0, {}};
    for (int k = 0; k < traits(*shape).vertices; ++k) {
      element.nodes[static_cast<std::size_t>(k)] = in_.integer("a node of " + name);
    }
    in_.end("the nodes of " + name);
    for (const auto group : groups) {
      const auto found = groups_.find({dimension, group});
      if (found == groups_.end()) {
        in_.fail(name + " belongs to physical group " + std::to_string(group) + " of dimension " +
                 std::to_string(dimension) + ", which has no name in $PhysicalNames");
      }
      element.group = found->second;
      file_.elements.push_back(element);
    }
  }

  LineScanner in_;
  MshFile file_;
  bool version4_ = false;
  std::string skip_to_;
  std::map<std::pair<int, long long>, int>
      groups_;  // dimension and number to place in file_.groups
  std::map<std::pair<int, long long>, std::vector<long long>>
      entities_;  // to their physical groups
};

}  // namespace

MshFile read_msh(const std::string& path) { return MshReader(path).read(); }

}  // namespace hawser
