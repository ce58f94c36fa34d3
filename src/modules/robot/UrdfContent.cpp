#include "robot/UrdfContent.hpp"

#include "io/XmlDocument.hpp"
#include "robot/UrdfChecks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <sstream>
#include <string_view>
#include <vector>

namespace naocal {

namespace {

/// The value of an attribute with one text per number: +0.10 and 1e-1 are 0.1, -0 is 0.
std::string attributeContent(const TiXmlElement& element, const TiXmlAttribute& attribute) {
  const std::string_view value = attribute.Value();
  const auto numbers = holdsNumbers(element.Value(), attribute.Name()) ? parseXmlNumbers(value) : std::vector<double>{};
  if (!numbers || numbers->empty()) {
    return std::string{value};
  }
  std::vector<double> plain = *numbers;
  for (double& number : plain) {
    number += 0.0; // -0 becomes 0
  }
  return fmt::format("{}", fmt::join(plain, " "));
}

/// Appends a text with its length, so that no other sequence of texts gives the same.
void append(std::string& content, char kind, std::string_view text) {
  content += fmt::format("{}{}:{}", kind, text.size(), text);
}

void appendElement(const TiXmlElement& element, std::string& content) {
  append(content, '<', element.Value());
  std::map<std::string, std::string> attributes;
  for (const TiXmlAttribute* entry = element.FirstAttribute(); entry != nullptr; entry = entry->Next()) {
    attributes.emplace(entry->Name(), attributeContent(element, *entry));
  }
  for (const auto& [name, value] : attributes) {
    append(content, '@', name);
    append(content, '=', value);
  }
  std::string words; // of the text between the elements within this one
  for (const TiXmlNode* child = element.FirstChild(); child != nullptr; child = child->NextSibling()) {
    if (child->ToElement() != nullptr) {
      appendElement(*child->ToElement(), content);
    } else if (child->ToText() != nullptr) {
      std::istringstream text{child->Value()};
      for (std::string word; text >> word;) {
        words += word + ' ';
      }
    }
  }
  append(content, '"', words);
  content += '>';
}

} // namespace

std::string urdfContent(const std::string& text) {
  const TiXmlDocument document = parseXml(text, "URDF", "a URDF");
  std::string content;
  if (const TiXmlElement* root = document.RootElement()) {
    appendElement(*root, content);
  }
  return content;
}

} // namespace naocal
