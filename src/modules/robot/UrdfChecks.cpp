#include "robot/UrdfChecks.hpp"

#include "io/InputError.hpp"
#include "io/JsonWriter.hpp"
#include "io/XmlDocument.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

namespace naocal {

namespace {

/// A URDF's document while it is checked.
struct UrdfText {
  TiXmlDocument document;
  std::string name; // of the file
};

[[noreturn]] void refuse(const UrdfText& urdf, const std::string& place, const std::string& expected,
                         const std::string& found) {
  throw InputError{fmt::format("{}, {}: expected {}, found {}", urdf.name, place, expected, found)};
}

std::string text(const TiXmlElement& element, const char* attribute) {
  const char* value = element.Attribute(attribute);
  return value == nullptr ? "" : value;
}

/// "link 'trunk'", "joint 'knee'" or "<origin> of joint 'knee'".
std::string placeOf(const TiXmlElement& element) {
  const std::string name = text(element, "name");
  const TiXmlNode* parent = element.Parent();
  const std::string own =
      name.empty() ? fmt::format("<{}>", element.Value()) : fmt::format("{} '{}'", element.Value(), name);
  const bool isTop =
      parent == nullptr || parent->ToElement() == nullptr || parent->Value() == std::string_view{"robot"};
  return isTop ? own : fmt::format("{} of {}", own, placeOf(*parent->ToElement()));
}

/// Applies `visit` to an element and all elements in it.
template <typename Visit> void visitElements(const TiXmlElement& element, const Visit& visit) {
  visit(element);
  for (const TiXmlElement* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    visitElements(*child, visit);
  }
}

/// Refuses names that a result or a column map, which are JSON, cannot hold.
void checkName(const UrdfText& urdf, const TiXmlElement& element) {
  const std::string name = text(element, "name");
  try {
    (void)nlohmann::json(name).dump();
  } catch (const nlohmann::json::exception&) {
    refuse(urdf, fmt::format("line {}, <{}>", element.Row(), element.Value()), "a name in UTF-8",
           compactText(name) + "; write it in UTF-8");
  }
}

void checkNames(const UrdfText& urdf) {
  const TiXmlElement* root = urdf.document.RootElement();
  checkName(urdf, *root);
  for (const char* tag : {"link", "joint"}) {
    for (const TiXmlElement* element = root->FirstChildElement(tag); element != nullptr;
         element = element->NextSiblingElement(tag)) {
      checkName(urdf, *element);
    }
  }
}

void refuseXacro(const UrdfText& urdf) {
  visitElements(*urdf.document.RootElement(), [&](const TiXmlElement& element) {
    const std::string_view tag = element.Value();
    bool isXacro = tag.starts_with("xacro:");
    for (const TiXmlAttribute* entry = element.FirstAttribute(); entry != nullptr; entry = entry->Next()) {
      const std::string_view value = entry->Value();
      isXacro = isXacro || value.find("${") != value.npos || value.find("$(") != value.npos;
    }
    if (isXacro) {
      throw InputError{fmt::format("{}, {}: a xacro file, not a URDF; expand it first: xacro {} > robot.urdf",
                                   urdf.name, placeOf(element), urdf.name)};
    }
  });
}

/// Refuses an attribute that holds other words than numbers, or a wrong count of them.
void requireNumbers(const UrdfText& urdf, const TiXmlElement& element, const char* attribute, std::size_t count) {
  const char* value = element.Attribute(attribute);
  if (value == nullptr) {
    return;
  }
  const auto numbers = parseXmlNumbers(value);
  if (!numbers) {
    refuse(urdf, placeOf(element), fmt::format("finite numbers in '{}'", attribute), fmt::format("'{}'", value));
  }
  if (numbers->size() != count) {
    refuse(urdf, placeOf(element), fmt::format("{} number{} in '{}'", count, count == 1 ? "" : "s", attribute),
           fmt::format("'{}'", value));
  }
}

/// An attribute that holds numbers, and how many.
struct NumericAttribute {
  const char *element, *attribute;
  std::size_t count;
};
constexpr std::array<NumericAttribute, 22> numericAttributes{
    {{"origin", "xyz", 3},       {"origin", "rpy", 3},       {"axis", "xyz", 3},         {"mass", "value", 1},
     {"inertia", "ixx", 1},      {"inertia", "ixy", 1},      {"inertia", "ixz", 1},      {"inertia", "iyy", 1},
     {"inertia", "iyz", 1},      {"inertia", "izz", 1},      {"limit", "lower", 1},      {"limit", "upper", 1},
     {"limit", "velocity", 1},   {"limit", "effort", 1},     {"box", "size", 3},         {"cylinder", "radius", 1},
     {"cylinder", "length", 1},  {"sphere", "radius", 1},    {"mimic", "multiplier", 1}, {"mimic", "offset", 1},
     {"dynamics", "damping", 1}, {"dynamics", "friction", 1}}};

void checkNumbers(const UrdfText& urdf) {
  visitElements(*urdf.document.RootElement(), [&](const TiXmlElement& element) {
    for (const NumericAttribute& numeric : numericAttributes) {
      if (element.Value() == std::string_view{numeric.element}) {
        requireNumbers(urdf, element, numeric.attribute, numeric.count);
      }
    }
  });
}

/// Name of the link that an element of a joint refers to.
std::string linkOf(const UrdfText& urdf, const TiXmlElement& joint, const char* role,
                   const std::vector<std::string>& links) {
  const TiXmlElement* element = joint.FirstChildElement(role);
  const std::string link = element == nullptr ? "" : text(*element, "link");
  if (std::find(links.begin(), links.end(), link) == links.end()) {
    refuse(urdf, placeOf(joint), fmt::format("a <{}> with the name of a link", role),
           link.empty() ? "none" : fmt::format("'{}'", link));
  }
  return link;
}

void checkJoint(const UrdfText& urdf, const TiXmlElement& joint) {
  static constexpr std::array<std::string_view, 4> types{"revolute", "continuous", "prismatic", "fixed"};
  const std::string type = text(joint, "type");
  if (std::find(types.begin(), types.end(), type) == types.end()) {
    refuse(urdf, placeOf(joint), fmt::format("a type among {}", fmt::join(types, ", ")), fmt::format("'{}'", type));
  }
  if ((type == "revolute" || type == "prismatic") && joint.FirstChildElement("limit") == nullptr) {
    refuse(urdf, placeOf(joint), fmt::format("a <limit>, as its type is {}", type), "none");
  }
}

std::vector<std::string> namesOf(const UrdfText& urdf, const char* tag) {
  std::vector<std::string> names;
  const TiXmlElement* element = urdf.document.RootElement()->FirstChildElement(tag);
  for (; element != nullptr; element = element->NextSiblingElement(tag)) {
    const std::string name = text(*element, "name");
    if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) {
      refuse(urdf, placeOf(*element), fmt::format("a name that no {} before has", tag),
             name.empty() ? "none" : fmt::format("'{}' again", name));
    }
    names.push_back(name);
  }
  return names;
}

/// Refuses links and joints that form no tree.
void checkTree(const UrdfText& urdf) {
  const std::vector<std::string> links = namesOf(urdf, "link");
  constexpr std::size_t most = 1000;
  if (links.empty() || links.size() > most) {
    refuse(urdf, "<robot>", fmt::format("1 to {} links", most), fmt::format("{}", links.size()));
  }
  namesOf(urdf, "joint");
  std::map<std::string, std::string> parents; // by child
  const TiXmlElement* joint = urdf.document.RootElement()->FirstChildElement("joint");
  for (; joint != nullptr; joint = joint->NextSiblingElement("joint")) {
    checkJoint(urdf, *joint);
    const std::string parent = linkOf(urdf, *joint, "parent", links), child = linkOf(urdf, *joint, "child", links);
    if (!parents.emplace(child, parent).second) {
      refuse(urdf, placeOf(*joint), "a tree, in which each link is the child of one joint",
             fmt::format("link '{}', which is another joint's child: the links form a loop", child));
    }
  }
  std::vector<std::string> roots;
  std::copy_if(links.begin(), links.end(), std::back_inserter(roots),
               [&](const std::string& link) { return parents.count(link) == 0; });
  if (roots.size() != 1) {
    refuse(urdf, "links", "one root, a link that is no joint's child",
           roots.empty() ? "none: the links form a loop" : fmt::format("{}: {}", roots.size(), fmt::join(roots, ", ")));
  }
  for (const std::string& link : links) {
    std::string at = link;
    for (std::size_t steps = 0; parents.count(at) != 0; ++steps) {
      if (steps > links.size()) {
        refuse(urdf, fmt::format("link '{}'", link), "a tree", "links that form a loop");
      }
      at = parents.at(at);
    }
  }
}

} // namespace

bool holdsNumbers(std::string_view element, std::string_view attribute) {
  return std::any_of(numericAttributes.begin(), numericAttributes.end(), [&](const NumericAttribute& numeric) {
    return numeric.element == element && numeric.attribute == attribute;
  });
}

void checkUrdf(const std::string& text, const std::string& name) {
  const UrdfText urdf{parseXml(text, name, "a URDF"), name};
  const TiXmlElement* root = urdf.document.RootElement();
  if (root == nullptr || root->Value() != std::string_view{"robot"}) {
    refuse(urdf, "top", "the element <robot>", root == nullptr ? "none" : fmt::format("<{}>", root->Value()));
  }
  checkNames(urdf);
  refuseXacro(urdf);
  checkNumbers(urdf);
  checkTree(urdf);
}

} // namespace naocal
