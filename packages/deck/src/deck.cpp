#include "hawser/deck/deck.hpp"

#include <algorithm>
#include <filesystem>

#include "hawser/base/error.hpp"
#include "hawser/deck/spec_reader.hpp"
#include "src/deck_edit.hpp"

namespace hawser {
namespace {

class Reader {
 public:
  Reader(const DeckFiles& files, const DeckLanguage& language, Diagnostics& diagnostics)
      : files_(files), language_(language), diagnostics_(diagnostics) {}

  /// `written_at`: the attribute that names the file; null for the first one.
  DeckNode read(const std::string& file, const Location* written_at) {
    open_.push_back(std::filesystem::path(file).lexically_normal().string());
    const std::optional<std::string> text = files_(file);
    if (!text)
      throw DeckError(written_at == nullptr
                          ? file + ": the deck cannot be read"
                          : written_at->text() + ": the deck to extend cannot be read: " + file);
    if (written_at == nullptr) first_text_ = *text;
    DeckNode root = parse_xml(*text, file, diagnostics_);
    if (const DeckAttribute* const extends = root.find_attribute("extends")) {
      has_bases_ = true;
      DeckNode base = read_base(file, root.tag, *extends);
      extend(base, root, language_, diagnostics_);
      root = std::move(base);
    }
    open_.pop_back();
    return root;
  }

  const std::string& first_text() const { return first_text_; }
  bool has_bases() const { return has_bases_; }

 private:
  DeckNode read_base(const std::string& file, const std::string& tag,
                     const DeckAttribute& extends) {
    const std::string name = trimmed(extends.value);
    const std::string base =
        (std::filesystem::path(file).parent_path() / name).lexically_normal().string();
    if (name.empty())
      throw DeckError(extends.location.text() +
                      ": attribute 'extends' is empty; needed: the path of another deck");
    if (open_.size() >= depth_limit)
      throw DeckError(extends.location.text() + ": decks extend each other over more than " +
                      std::to_string(depth_limit) + " files");
    if (std::find(open_.begin(), open_.end(), base) != open_.end())
      throw DeckError(extends.location.text() +
                      ": decks extend each other in a circle: " + chain() + base);
    DeckNode root = read(base, &extends.location);
    if (root.tag != tag)
      throw DeckError(extends.location.text() + ": <" + tag + "> cannot extend " + base +
                      ", which holds <" + root.tag + ">");
    return root;
  }

  std::string chain() const {
    std::string text;
    for (const std::string& file : open_)
      text += file + " -> ";
    return text;
  }

  static constexpr std::size_t depth_limit = 32;
  const DeckFiles& files_;
  const DeckLanguage& language_;
  Diagnostics& diagnostics_;
  std::vector<std::string> open_;  // from the first deck to the one being read
  std::string first_text_;
  bool has_bases_ = false;
};

}  // namespace

const DeckAttribute* DeckNode::find_attribute(const std::string& name) const {
  for (const DeckAttribute& attribute : attributes)
    if (attribute.name == name) return &attribute;
  return nullptr;
}

const DeckNode* DeckNode::find_child(const std::string& child_tag) const {
  for (const DeckNode& child : children)
    if (child.tag == child_tag) return &child;
  return nullptr;
}

Deck parse_deck(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  Deck deck{file, text, parse_xml(text, file, diagnostics)};
  define_parameters(deck.root, diagnostics);
  return deck;
}

Deck read_deck(const DeckFiles& files, const std::string& file,
               const std::vector<DeckChange>& changes, const DeckLanguage& language,
               Diagnostics& diagnostics) {
  Reader reader(files, language, diagnostics);
  Deck deck{file, "", reader.read(file, nullptr)};
  deck.text = reader.first_text();
  for (const DeckChange& change : changes)
    apply(change, deck.root, language, diagnostics);
  if (reader.has_bases() || !changes.empty()) deck.text = deck_text(deck.root);
  define_parameters(deck.root, diagnostics);
  return deck;
}

Deck read_deck(const Communicator& communicator, const std::string& file,
               const std::vector<DeckChange>& changes, const DeckLanguage& language,
               Diagnostics& diagnostics) {
  return read_deck(std::make_shared<InputFiles>(communicator), file, changes, language,
                   diagnostics);
}

Deck read_deck(const std::shared_ptr<InputFiles>& files, const std::string& file,
               const std::vector<DeckChange>& changes, const DeckLanguage& language,
               Diagnostics& diagnostics) {
  // parse_xml sees by one byte more than is allowed that it is too much.
  const DeckFiles texts = [&](const std::string& name) {
    return files->read(name, deck_size_limit);
  };
  Deck deck = read_deck(texts, file, changes, language, diagnostics);
  deck.files = files;
  return deck;
}

Deck read_deck(const Communicator& communicator, const std::string& file,
               Diagnostics& diagnostics) {
  return read_deck(communicator, file, {}, {}, diagnostics);
}

std::string path_beside(const Deck& deck, const Located<std::string>& name) {
  const std::filesystem::path path = name.value;
  if (path.is_absolute()) return path.string();
  const std::string& written_in = name.location.line > 0 ? name.location.file : deck.file;
  return (std::filesystem::path(written_in).parent_path() / path).string();
}

}  // namespace hawser
