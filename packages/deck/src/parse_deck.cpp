// XML to DeckNode. pugixml parses in place, so a name's address tells where it stands in the text.
#include <pugixml.hpp>

#include <algorithm>
#include <cstring>
#include <functional>

#include "hawser/base/error.hpp"
#include "src/deck_edit.hpp"

namespace hawser {
namespace {

constexpr int element_limit = 100000;

/// From the offset in a text to line and column.
class Places {
 public:
  Places(const std::string& text, const std::string& file) : text_(text), file_(file) {
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '\n') line_begins_.push_back(i + 1);
  }

  Location at(std::size_t offset) const {
    offset = std::min(offset, text_.size());
    const auto next = std::upper_bound(line_begins_.begin(), line_begins_.end(), offset);
    const std::size_t begin = *(next - 1);
    // Counted on from the last place: a deck of one long line would take its length squared.
    if (last_ > offset || last_ < begin) last_ = begin, last_column_ = 1;
    // Bytes that continue a character of UTF-8 are no columns of their own.
    for (; last_ < offset; ++last_)
      last_column_ += (static_cast<unsigned char>(text_[last_]) & 0xC0) != 0x80 ? 1 : 0;
    return {file_, static_cast<int>(next - line_begins_.begin()), last_column_};
  }

 private:
  const std::string& text_;
  const std::string& file_;
  std::vector<std::size_t> line_begins_{0};
  mutable std::size_t last_ = 0;
  mutable int last_column_ = 1;
};

class Converter {
 public:
  Converter(const std::string& text, const std::string& buffer, const std::string& file,
            Diagnostics& diagnostics)
      : places_(text, file), text_(text), buffer_(buffer), diagnostics_(diagnostics) {}

  DeckNode root(const pugi::xml_document& document) {
    DeckNode result;
    int elements = 0;
    for (const pugi::xml_node node : document) {
      if (node.type() != pugi::node_element)
        refuse(node, "outside of the root element");
      else if (++elements == 1)
        result = element(node, 1);
      else
        diagnostics_.error(place(node.name()), std::string("<") + node.name() +
                                                   "> is a second root element; allowed: one");
    }
    if (elements == 0) throw DeckError(places_.at(0).text() + ": the deck holds no element");
    return result;
  }

  const Places& places() const { return places_; }

 private:
  std::size_t offset(const char* position) const {
    const char* begin = buffer_.data();
    const bool inside = std::less_equal<>()(begin, position) &&
                        std::less_equal<>()(position, begin + buffer_.size());
    return inside ? static_cast<std::size_t>(position - begin) : 0;
  }
  Location place(const char* position) const { return places_.at(offset(position)); }

  DeckNode element(const pugi::xml_node& node, int depth) {
    check_element(node);
    DeckNode result{node.name(), place(node.name()), {}, {}, {}};
    if (depth > deck_depth_limit)
      throw DeckError(result.location.text() + ": elements are nested too deeply; allowed: " +
                      std::to_string(deck_depth_limit) + " levels");
    for (const pugi::xml_attribute attribute : node.attributes())
      add_attribute(result, attribute);
    for (const pugi::xml_node child : node) {
      if (child.type() == pugi::node_element) {
        if (!is_foreign(child)) result.children.push_back(element(child, depth + 1));
      } else
        refuse(child, "in <" + result.tag + ">");
    }
    return result;
  }

  void check_element(const pugi::xml_node& node) {
    if (++elements_ > element_limit)
      throw DeckError(place(node.name()).text() + ": the deck has more than " +
                      std::to_string(element_limit) + " elements");
  }

  bool is_foreign(const pugi::xml_node& node) {
    if (std::strchr(node.name(), ':') == nullptr) return false;
    diagnostics_.error(place(node.name()),
                       "<" + std::string(node.name()) +
                           ">: XInclude and other namespaces are not allowed in a deck; "
                           "extends=\"other.xml\" takes over another deck");
    return true;
  }

  void add_attribute(DeckNode& node, const pugi::xml_attribute& attribute) {
    const Location where = place(attribute.name());
    const DeckAttribute* first = node.find_attribute(attribute.name());
    if (!first) {
      node.attributes.push_back({attribute.name(), attribute.value(), where});
      return;
    }
    diagnostics_.error(where, "attribute '" + first->name + "' of <" + node.tag +
                                  "> is given twice, as " + quoted(first->value) + " and as " +
                                  quoted(attribute.value()) + "; allowed: once");
  }

  void refuse(const pugi::xml_node& node, const std::string& where) {
    switch (node.type()) {
      case pugi::node_doctype:
        diagnostics_.error(places_.at(text_.find("<!DOCTYPE")),
                           "a DOCTYPE is not allowed in a deck");
        break;
      case pugi::node_pi:
        diagnostics_.error(place(node.name()), "the processing instruction " + quoted(node.name()) +
                                                   " is not allowed in a deck");
        break;
      case pugi::node_pcdata:
      case pugi::node_cdata: {
        const std::size_t begin = text_.find_first_not_of(" \t\r\n", offset(node.value()));
        std::string given = node.value();
        given.erase(0, given.find_first_not_of(" \t\r\n"));
        given.erase(given.find_last_not_of(" \t\r\n") + 1);
        diagnostics_.error(places_.at(begin),
                           "text is not allowed " + where + ", but " + quoted(given) + " is given");
        break;
      }
      default: break;  // comments and the XML declaration are not kept
    }
  }

  Places places_;
  const std::string& text_;
  const std::string& buffer_;
  Diagnostics& diagnostics_;
  int elements_ = 0;
};

/// Where the name of the innermost element stands that is still open at `end`; npos: none is. The
/// text up to there has been read without a fault, but for an end tag at `end` itself.
std::size_t open_element(const std::string& text, std::size_t end) {
  std::vector<std::size_t> open;
  for (std::size_t at = text.find('<'); at < end; at = text.find('<', at)) {
    const auto skip = [&](const char* begin, const char* close) {
      if (text.compare(at, std::strlen(begin), begin) != 0) return false;
      at = text.find(close, at + std::strlen(begin));
      return true;
    };
    if (skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<?", "?>")) continue;
    const bool ends = text[at + 1] == '/';
    if (ends && text.find('>', at) < end && !open.empty()) open.pop_back();
    if (!ends) open.push_back(at + 1);
    for (char quote = 0; at < text.size() && (quote != 0 || text[at] != '>'); ++at)
      if (text[at] == quote)
        quote = 0;
      else if (quote == 0 && (text[at] == '"' || text[at] == '\''))
        quote = text[at];
    if (!ends && at < text.size() && text[at - 1] == '/') open.pop_back();
  }
  return open.empty() ? std::string::npos : open.back();
}

std::string sentence(pugi::xml_parse_status status, bool at_end) {
  switch (status) {
    case pugi::status_unrecognized_tag:
      return "'<' does not begin a tag; write &lt; for the character itself";
    case pugi::status_bad_pi: return "the '<?' is not closed with '?>'";
    case pugi::status_bad_comment: return "the comment is not closed with '-->'";
    case pugi::status_bad_cdata: return "the CDATA section is not closed with ']]>'";
    case pugi::status_bad_doctype: return "a DOCTYPE is not allowed in a deck";
    case pugi::status_bad_pcdata: return "the text is not followed by a tag";
    case pugi::status_bad_start_element: return "the start tag is not closed with '>'";
    case pugi::status_bad_attribute: return "an attribute must be written name=\"value\"";
    case pugi::status_bad_end_element: return "the end tag is not closed with '>'";
    case pugi::status_end_element_mismatch:
      return at_end ? "the deck ends before all its elements are closed"
                    : "the end tag does not match the element that is open";
    default: return "the deck is not well-formed XML";
  }
}

void check_bytes(const std::string& text, const std::string& file) {
  if (text.size() > deck_size_limit)
    throw DeckError(file + ": the deck is larger than the allowed " +
                    std::to_string(deck_size_limit >> 20) + " MB");
  if (text.find('\0') != std::string::npos)
    throw DeckError(file + ": the deck holds a zero byte; it must be UTF-8 text");
}

}  // namespace

DeckNode parse_xml(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  check_bytes(text, file);
  std::string buffer = text + '\n';  // pugixml overwrites the last character
  Converter converter(text, buffer, file, diagnostics);
  pugi::xml_document document;
  const unsigned options = pugi::parse_default | pugi::parse_doctype | pugi::parse_pi |
                           pugi::parse_fragment;  // fragment: shows text outside of the root
  const pugi::xml_parse_result result =
      document.load_buffer_inplace(buffer.data(), buffer.size(), options, pugi::encoding_utf8);
  if (!result) {
    auto offset = static_cast<std::size_t>(result.offset);
    const bool at_end = text.find_first_not_of(" \t\r\n", offset) == std::string::npos;
    // An unclosed comment runs to the end of the deck: what helps is where it begins.
    if (result.status == pugi::status_bad_comment) offset = text.rfind("<!--", offset);
    std::string what = sentence(result.status, at_end);
    if (result.status == pugi::status_end_element_mismatch) {
      const std::size_t name = open_element(text, offset);
      if (name != std::string::npos)
        what += ": <" + text.substr(name, text.find_first_of(" \t\r\n/>", name) - name) +
                "> of line " + std::to_string(converter.places().at(name).line);
    }
    throw DeckError(converter.places().at(offset).text() + ": " + what);
  }
  return converter.root(document);
}

}  // namespace hawser
