#include "msh_file.hpp"

#include <cstdlib>
#include <map>
#include <set>
#include <utility>

#include "msh_groups.hpp"
#include "msh_scanner.hpp"
#include "msh_types.hpp"

namespace hawser {
namespace {

class MshReader {
 public:
  explicit MshReader(const std::string& path) : in_(path) { file_.path = path; }

  MshFile read() {
    if (!in_.next()) in_.fail("the file is empty");
    const std::string first(in_.word("$MeshFormat"));
    if (first == "\xEF\xBB\xBF$MeshFormat")
      in_.fail("the file begins with a byte-order mark; save it without one");
    if (first != "$MeshFormat") in_.fail("expected $MeshFormat: no MSH file");
    read_format();
    close("$MeshFormat");
    while (in_.next()) {
      const std::string section(in_.word("a section"));
      if (section[0] != '$') in_.fail("expected a section such as $Nodes, found '" + section + "'");
      read_section(section);
      close(section);
    }
    if (file_.nodes.empty()) in_.fail("the file has no nodes");
    refuse_part_of_a_mesh();
    if (file_.elements.empty())
      in_.fail(
          "no element belongs to a physical group; in gmsh: Physical Surface(\"water\") = {1}");
    name_groups(file_);
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
    const bool binary = in_.integer("the file type") == 1;
    const auto bytes = in_.integer("the bytes of a number");
    if (!binary) return;
    if (bytes != 8)
      in_.fail("numbers of " + std::to_string(bytes) + " bytes are not read, only of 8");
    in_.read_binary(version4_);
  }

  void read_section(const std::string& section) {
    if (section == "$PhysicalNames") {
      read_names();
    } else if (section == "$Entities" && version4_) {
      read_entities();
    } else if (section == "$PartitionedEntities" && version4_) {
      read_parts();
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

  /// At the begin of a section. In MSH 4 nodes and elements have three numbers more.
  long long counted(const std::string& what) {
    if (!in_.is_binary() || !version4_) {
      in_.next("the number of " + what);
      return in_.text().count("the number of " + what);
    }
    const auto blocks = in_.count("the number of " + what);
    for (const char* const more : {"the number of all", "the least number", "the greatest number"})
      in_.count(more);
    return blocks;
  }

  void read_names() {
    auto& text = in_.text();
    text.next("the number of physical names");
    for (auto n = text.count("the number of physical names"); n > 0; --n) {
      text.next("a physical name");
      MshGroup group;
      group.dimension = static_cast<int>(text.integer("a dimension"));
      group.tag = text.integer("a physical number");
      group.name = text.quoted("a physical name");
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

  void skip_coordinates(int dimension) {
    for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k)
      in_.real("a coordinate");
  }

  /// gmsh writes a negative number for a curve that its group takes backwards.
  long long group_of(long long number) const {
    if (std::abs(static_cast<double>(number)) > 1e18)
      in_.fail(std::to_string(number) + " is no number of a physical group");
    return std::abs(number);
  }

  std::vector<long long> read_groups() {
    std::vector<long long> groups;
    for (auto n = in_.count("the number of physical groups"); n > 0; --n)
      groups.push_back(group_of(in_.integer("a physical number")));
    return groups;
  }

  /// What bounds an entity; in text nobody reads the rest of the line.
  void skip_bounds(int dimension) {
    if (!in_.is_binary() || dimension == 0) return;
    for (auto n = in_.count("the number of bounding entities"); n > 0; --n)
      in_.integer("a bounding entity");
  }

  template <class ReadEntity>
  void each_entity(ReadEntity&& read) {
    std::array<long long, 4> counts;
    in_.record("the numbers of entities");
    for (auto& number : counts)
      number = in_.count("a number of entities");
    for (int dimension = 0; dimension < 4; ++dimension)
      for (auto n = counts[static_cast<std::size_t>(dimension)]; n > 0; --n) {
        in_.record("an entity");
        read(dimension, in_.integer("an entity's number"));
        skip_bounds(dimension);
      }
  }

  void read_entities() {
    each_entity([&](int dimension, long long entity) {
      skip_coordinates(dimension);
      entities_[{dimension, entity}] = read_groups();
    });
  }

  // Pieces of the entities, of which gmsh then makes the blocks of elements. A piece of what the
  // geometry calls an entity of its dimension is in that one's groups; the others are the parts'
  // common boundaries, which are nothing here.
  void read_parts() {
    in_.record("the number of parts");
    parts_ = in_.count("the number of parts");
    in_.record("the number of ghost entities");
    for (auto n = in_.count("the number of ghost entities"); n > 0; --n) {
      in_.record("a ghost entity");
      in_.integer("a ghost entity's number");
      in_.integer("a part");
    }
    each_entity([&](int dimension, long long entity) {
      const auto parent_dimension = static_cast<int>(in_.integer("the parent's dimension"));
      const auto parent = in_.integer("the parent's number");
      for (auto n = in_.count("the number of parts"); n > 0; --n) {
        const auto part = in_.integer("a part");
        if (dimension == parent_dimension) parts_there_.insert(part);
      }
      skip_coordinates(dimension);
      auto groups = read_groups();
      const auto whole = entities_.find({parent_dimension, parent});
      if (groups.empty() && whole != entities_.end()) groups = whole->second;
      if (dimension != parent_dimension) groups.clear();
      entities_[{dimension, entity}] = groups;
    });
  }

  void refuse_part_of_a_mesh() const {
    const auto there = static_cast<long long>(parts_there_.size());
    if (there < parts_)
      in_.fail("the file holds " + std::to_string(there) + " of the " + std::to_string(parts_) +
               " parts of a partitioned mesh; write all parts into one file "
               "(Mesh.PartitionSplitMeshFiles = 0)");
  }

  void read_position(MshNode& node) {
    node.line = in_.line();
    for (auto& x : node.position)
      x = in_.real("a coordinate");
  }

  void read_nodes2() {
    for (auto n = counted("nodes"); n > 0; --n) {
      in_.record("a node");
      MshNode node{};
      node.tag = in_.tag("a node number");
      read_position(node);
      in_.end_record("the node's coordinates");
      file_.nodes.push_back(node);
    }
  }

  void read_nodes4() {
    for (auto blocks = counted("node blocks"); blocks > 0; --blocks) {
      in_.record("a block of nodes");
      const auto dimension = in_.integer("a dimension");
      in_.integer("an entity's number");
      const bool parametric = in_.integer("0 or 1") != 0;
      const auto nodes = in_.count("the number of nodes in the block");
      const auto first = file_.nodes.size();
      for (long long k = 0; k < nodes; ++k) {
        in_.record("a node number");
        file_.nodes.push_back({in_.tag("a node number"), 0, {}});
      }
      for (auto node = first; node < file_.nodes.size(); ++node) {
        in_.record("a node's coordinates");
        read_position(file_.nodes[node]);  // parametric coordinates may follow
        for (long long k = 0; in_.is_binary() && parametric && k < dimension; ++k)
          in_.real("a parametric coordinate");
      }
    }
  }

  void read_elements2() {
    for (auto left = counted("elements"); left > 0;) {
      // Text has a header in each element, a binary file one for several.
      in_.record("an element");
      long long number = in_.is_binary() ? 0 : in_.integer("an element number");
      const auto type = in_.integer("an element type");
      const auto block = in_.is_binary() ? in_.integer("the number of elements in the block") : 1;
      if (block < 1) in_.fail("expected elements in the block, found " + std::to_string(block));
      const auto tags = in_.integer("the number of tags");
      if (tags < 0) in_.fail("the number of tags is negative: " + std::to_string(tags));
      for (auto k = block; k > 0; --k, --left) {
        if (in_.is_binary()) number = in_.integer("an element number");
        std::vector<long long> groups;
        for (auto t = 0LL; t < tags; ++t) {
          const auto value = in_.integer("a tag");
          if (t == 0 && value != 0) groups.push_back(group_of(value));  // the others are gmsh's own
        }
        read_element(number, type, groups);
      }
    }
  }

  void read_elements4() {
    for (auto blocks = counted("element blocks"); blocks > 0; --blocks) {
      in_.record("a block of elements");
      const auto dimension = static_cast<int>(in_.integer("a dimension"));
      const auto entity = in_.integer("an entity's number");
      const auto type = in_.integer("an element type");
      const auto elements = in_.count("the number of elements in the block");
      const auto groups = entities_.find({dimension, entity});
      if (groups == entities_.end()) {
        in_.fail("$Entities has no entity " + std::to_string(entity) + " of dimension " +
                 std::to_string(dimension));
      }
      for (long long k = 0; k < elements; ++k) {
        in_.record("an element");
        const auto number = in_.tag("an element number");
        read_element(number, type, groups->second);
      }
    }
  }

  void leave_out(long long number, long long type) {
    if (const auto shape = shape_of(type))
      ++file_.left_out[static_cast<std::size_t>(traits(*shape).dimension)];
    if (!in_.is_binary()) return;
    const int nodes = nodes_of(type);
    if (nodes == 0)
      in_.fail("element " + std::to_string(number) + " is of gmsh's type " + std::to_string(type) +
               ", whose nodes are not known; write the file as ASCII (Mesh.Binary = 0)");
    for (int k = 0; k < nodes; ++k)
      in_.tag("a node of an element");
  }

  void read_element(long long number, long long type, const std::vector<long long>& groups) {
    if (groups.empty()) return leave_out(number, type);
    const auto name = "element " + std::to_string(number);
    const auto shape = shape_of(type);
    if (!shape) in_.fail(name + " is " + what_is_refused(type));
    const int dimension = traits(*shape).dimension;
    MshElement element{number, in_.line(), *shape, 0, {}};
    const auto node = "a node of " + name;
    for (int k = 0; k < traits(*shape).vertices; ++k)
      element.nodes[static_cast<std::size_t>(k)] = in_.tag(node);
    in_.end_record("the nodes of " + name);
    for (const auto group : groups) {
      const auto [known, fresh] =
          groups_.emplace(std::pair(dimension, group), static_cast<int>(file_.groups.size()));
      if (fresh) file_.groups.push_back({"", dimension, group});
      element.group = known->second;
      file_.elements.push_back(element);
    }
  }

  MshScanner in_;
  MshFile file_;
  bool version4_ = false;
  std::string skip_to_;
  std::map<std::pair<int, long long>, int>
      groups_;  // dimension and number to place in file_.groups
  std::map<std::pair<int, long long>, std::vector<long long>>
      entities_;                     // to their physical groups
  long long parts_ = 0;              // that the file says there are
  std::set<long long> parts_there_;  // that hold anything of it
};

}  // namespace

MshFile read_msh(const std::string& path) { return MshReader(path).read(); }

}  // namespace hawser
