#include <gmock/gmock.h>

#include "hawser/base/error.hpp"
#include "hawser/deck/deck.hpp"

namespace hawser {
namespace {

std::string faults_of(const std::string& text) {
  Diagnostics diagnostics;
  try {
    parse_deck(text, "d.xml", diagnostics);
  } catch (const DeckError& error) {
    return std::string("thrown ") + error.what();
  }
  return diagnostics.error_text();
}

TEST(ParseDeck, EveryElementAndAttributeKnowsItsPlace) {
  Diagnostics diagnostics;
  const Deck deck = parse_deck(
      "<?xml version=\"1.0\"?>\n"
      "<!-- a comment -->\n"
      "<hawser  title='a &lt; b &amp; c'>\n"
      "  <mesh\n"
      "     file=\"m.msh\" label=\"Stra\u00dfe\" size='2'/>\n"
      "</hawser>\n",
      "d.xml", diagnostics);
  EXPECT_EQ(diagnostics.error_text(), "");
  const DeckNode& root = deck.root;
  EXPECT_EQ(root.location.text(), "d.xml:3:2");
  EXPECT_EQ(root.find_attribute("title")->value, "a < b & c");
  EXPECT_EQ(root.find_attribute("title")->location.text(), "d.xml:3:10");
  const DeckNode* mesh = root.find_child("mesh");
  ASSERT_NE(mesh, nullptr);
  EXPECT_EQ(mesh->location.text(), "d.xml:4:4");
  EXPECT_EQ(mesh->find_attribute("file")->location.text(), "d.xml:5:6");
  // In characters, not bytes: the sharp s takes two.
  EXPECT_EQ(mesh->find_attribute("size")->location.text(), "d.xml:5:34");
  EXPECT_EQ(mesh->find_attribute("absent"), nullptr);
  EXPECT_EQ(root.find_child("absent"), nullptr);
}

TEST(ParseDeck, WhatXmlAllowsButADeckDoesNot) {
  EXPECT_EQ(faults_of("<a>\n  hello\n</a>"),
            "d.xml:2:3: text is not allowed in <a>, but 'hello' is given");
  EXPECT_EQ(faults_of("<a><![CDATA[x]]></a>"),
            "d.xml:1:13: text is not allowed in <a>, but 'x' is given");
  EXPECT_EQ(faults_of("<a/> x"),
            "d.xml:1:6: text is not allowed outside of the root element, but 'x' is given");
  EXPECT_EQ(faults_of("<a b='1' c='2'\n   b='3'/>"),
            "d.xml:2:4: attribute 'b' of <a> is given twice, as '1' and as '3'; allowed: once");
  EXPECT_EQ(faults_of("\n<!DOCTYPE a [<!ENTITY x \"y\">]>\n<a/>"),
            "d.xml:2:1: a DOCTYPE is not allowed in a deck");
  EXPECT_EQ(faults_of("<a>\n<xi:include href='b.xml'/></a>"),
            "d.xml:2:2: <xi:include>: XInclude and other namespaces are not allowed in a deck; "
            "extends=\"other.xml\" takes over another deck");
  EXPECT_EQ(faults_of("<a><?php x?></a>"),
            "d.xml:1:6: the processing instruction 'php' is not allowed in a deck");
  EXPECT_EQ(faults_of("<a/>\n<b/>"), "d.xml:2:2: <b> is a second root element; allowed: one");
}

TEST(ParseDeck, MalformedXmlIsThrownWithItsPlace) {
  EXPECT_EQ(faults_of(""), "thrown d.xml:1:1: the deck holds no element");
  EXPECT_EQ(faults_of("<a>\n<b>\n</a>"),
            "thrown d.xml:3:3: the end tag does not match the element that is open: <b> of line 2");
  EXPECT_EQ(faults_of("<a>\n<b/>\n"),
            "thrown d.xml:3:1: the deck ends before all its elements are closed: <a> of line 1");
  EXPECT_EQ(faults_of("<a>\n</b/>"),
            "thrown d.xml:2:3: the end tag does not match the element that is open: <a> of line 1");
  EXPECT_EQ(faults_of("</b/>"),
            "thrown d.xml:1:3: the end tag does not match the element that is open");
  EXPECT_EQ(faults_of("<a>\n<!-- <x> --><b c='>'/><d></d\n><e f=\"/>\">\n</a>"),
            "thrown d.xml:4:3: the end tag does not match the element that is open: <e> of line 3");
  EXPECT_EQ(faults_of("<a>\n<b c=1/></a>"),
            "thrown d.xml:2:6: an attribute must be written name=\"value\"");
  EXPECT_EQ(faults_of("<a>\n< b/></a>"),
            "thrown d.xml:2:2: '<' does not begin a tag; write &lt; for the character itself");
  EXPECT_EQ(faults_of("<a><!-- x </a>"), "thrown d.xml:1:4: the comment is not closed with '-->'");
}

TEST(ParseDeck, LimitsOfSizeAndDepth) {
  std::string nested;
  for (int i = 0; i <= deck_depth_limit; ++i)
    nested += "<a>";
  for (int i = 0; i <= deck_depth_limit; ++i)
    nested += "</a>";
  EXPECT_EQ(faults_of(nested),
            "thrown d.xml:1:194: elements are nested too deeply; allowed: 64 levels");
  std::string many;
  for (int i = 0; i < 100000; ++i)
    many += "<b/>";
  EXPECT_EQ(faults_of("<a>" + many + "</a>"),
            "thrown d.xml:1:400001: the deck has more than 100000 elements");
  const std::string large = "<a>" + std::string(deck_size_limit, ' ') + "</a>";
  EXPECT_EQ(faults_of(large), "thrown d.xml: the deck is larger than the allowed 16 MB");
  EXPECT_EQ(faults_of(std::string("<a>\0</a>", 8)),
            "thrown d.xml: the deck holds a zero byte; it must be UTF-8 text");
}

}  // namespace
}  // namespace hawser
