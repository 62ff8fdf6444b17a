// The XML Schema of decks, for editors and xmllint.
#include <sstream>

#include "hawser/deck/manual.hpp"
#include "src/describe.hpp"

namespace hawser {
namespace {

// A number may carry a unit or be a formula, so a schema can say little about it: only what it
// surely is not.
const char* const types = R"(  <xs:simpleType name="value">
    <xs:annotation>
      <xs:documentation>A number, a number and its unit, or a formula of parameters.</xs:documentation>
    </xs:annotation>
    <xs:restriction base="xs:string">
      <xs:pattern value="\s*[^{}\[\];\s]([^{}\[\];])*"/>
    </xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="values">
    <xs:annotation>
      <xs:documentation>Numbers set apart by blanks, or formulas set apart by ';'.</xs:documentation>
    </xs:annotation>
    <xs:restriction base="xs:string">
      <xs:pattern value="\s*[^{}\[\]\s]([^{}\[\]])*"/>
    </xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="text">
    <xs:restriction base="xs:string">
      <xs:pattern value="\s*\S(.|\s)*"/>
    </xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="truth">
    <xs:restriction base="xs:token">
      <xs:enumeration value="true"/>
      <xs:enumeration value="false"/>
    </xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="removal">
    <xs:annotation>
      <xs:documentation>In a deck that extends another one: takes the element away.</xs:documentation>
    </xs:annotation>
    <xs:restriction base="xs:token">
      <xs:enumeration value="true"/>
    </xs:restriction>
  </xs:simpleType>
)";

class SchemaWriter {
 public:
  explicit SchemaWriter(const DeckLanguage& language) : language_(language) {}

  std::string write() {
    out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         << "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\">\n"
         << types;
    element(language_.root, "  ", true);
    out_ << "</xs:schema>\n";
    return out_.str();
  }

 private:
  void element(const NodeSpec& spec, const std::string& indent, bool is_root = false) {
    out_ << indent << "<xs:element name=\"" << spec.tag << "\">\n";
    document(spec.meaning, indent + "  ");
    out_ << indent << "  <xs:complexType>\n";
    children(spec, indent + "    ");
    for (const AttributeSpec& attribute : spec.attributes)
      write(attribute, indent + "    ");
    if (!is_root) out_ << indent << "    <xs:attribute name=\"remove\" type=\"removal\"/>\n";
    out_ << indent << "  </xs:complexType>\n" << indent << "</xs:element>\n";
  }

  // In any order; a schema of the first version cannot say both that and how often.
  void children(const NodeSpec& spec, const std::string& indent) {
    const std::vector<ChildSpec> all = language_.children(spec);
    if (all.empty()) return;
    out_ << indent << "<xs:choice minOccurs=\"0\" maxOccurs=\"unbounded\">\n";
    for (const ChildSpec& child : all)
      element(child.node, indent + "  ");
    out_ << indent << "</xs:choice>\n";
  }

  void write(const AttributeSpec& attribute, const std::string& indent) {
    const std::vector<std::string>& words = attribute.choices;
    const bool one_of_words = !words.empty() && attribute.type != "list of names";
    out_ << indent << "<xs:attribute name=\"" << attribute.name << "\"";
    if (!one_of_words) out_ << " type=\"" << type_of(attribute) << "\"";
    out_ << ">\n";
    document(attribute.meaning + " (" + properties(attribute) + ")", indent + "  ");
    if (one_of_words) {
      out_ << indent << "  <xs:simpleType>\n"
           << indent << "    <xs:restriction base=\"xs:token\">\n";
      for (const std::string& word : words)
        out_ << indent << "      <xs:enumeration value=\"" << xml_escaped(word) << "\"/>\n";
      out_ << indent << "    </xs:restriction>\n" << indent << "  </xs:simpleType>\n";
    }
    out_ << indent << "</xs:attribute>\n";
  }

  static std::string type_of(const AttributeSpec& attribute) {
    if (attribute.type == "true or false") return "truth";
    if (!attribute.resolve) return "text";
    return attribute.type.compare(0, 4, "list") == 0 ? "values" : "value";
  }

  void document(const std::string& text, const std::string& indent) {
    out_ << indent << "<xs:annotation><xs:documentation>" << xml_escaped(text)
         << "</xs:documentation></xs:annotation>\n";
  }

  const DeckLanguage& language_;
  std::ostringstream out_;
};

}  // namespace

std::string schema(const DeckLanguage& language) { return SchemaWriter(language).write(); }

}  // namespace hawser
