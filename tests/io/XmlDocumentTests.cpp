#include "io/XmlDocument.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <random>

using namespace naocal;

namespace {

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) {
    all += text;
  }
  return all;
}

int depthOf(const TiXmlNode& node) {
  int deepest = 0;
  for (const TiXmlNode* child = node.FirstChild(); child != nullptr; child = child->NextSibling()) {
    deepest = std::max(deepest, depthOf(*child) + (child->ToElement() != nullptr ? 1 : 0));
  }
  return deepest;
}

bool isTooDeep(const std::string& text) {
  try {
    parseXml(text, "a.xml", "XML");
  } catch (const InputError& error) {
    return std::string{error.what()}.find("within each other") != std::string::npos;
  }
  return false;
}

} // namespace

TEST_CASE("elements within each other are counted as TinyXML sees them") {
  // Proves that quoted values, comments, CDATA and declarations hide no element: these texts ended the process.
  const std::vector<std::string> openings{
      "<a>",           "<a b=\"/>\">", "<a b='/>'>", "<a><!--> </</ -->", "<a><![CDATA[</</]]>", "<a><?b </</ ?>",
      "<a><!b </</ >", "<a><9 '>",     "<\xe4>"};
  for (const std::string& opening : openings) {
    CAPTURE(opening);
    CHECK(isTooDeep(repeated(opening, 100'000)));
  }
  for (const std::string& sibling : {"<a/>", "<a b='>'></a>", "<a b=1/>", "<a><!-- <b> --></a>", "<!b>", "<?b?>"}) {
    CAPTURE(sibling);
    CHECK_NOTHROW(parseXml("<r>" + repeated(sibling, 1000) + "</r>", "a.xml", "XML"));
  }
}

TEST_CASE("random XML in which TinyXML sees too many elements within each other is refused") {
  // Proves it for ten thousand texts, most of them broken: what TinyXML parses before an error counts.
  const std::array<std::string, 18> pieces{"<a>", "<a b=\"/>\">", "</a>",     "<!--", "-->", "<![CDATA[",
                                           "]]>", "\"",           "'",        "<9 ",  "<?x", ">",
                                           "</",  "/>",           "<a b=c/>", "c",    "<a ", "b="};
  std::mt19937 random{1};
  int deep = 0;
  for (int i = 0; i < 10'000; ++i) {
    std::string text;
    for (int part = 0; part < 40; ++part) {
      text += repeated("<a>", static_cast<int>(random() % 12)) + pieces[random() % pieces.size()];
    }
    TiXmlDocument document;
    document.Parse(text.c_str());
    if (depthOf(document) > 100) {
      ++deep;
      CAPTURE(text);
      CHECK(isTooDeep(text));
    }
  }
  CHECK(deep > 100);
}

TEST_CASE("broken XML is refused with line and column") {
  CHECK_THROWS_WITH(parseXml("<a>\n  <b></c></a>", "a.xml", "XML"), Catch::Contains("a.xml, line 2, column"));
  CHECK_THROWS_WITH(parseXml(std::string{"<a/>\0", 5}, "a.xml", "a URDF"), "a.xml: expected a URDF, found a zero byte");
}
