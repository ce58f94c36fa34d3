#include "dialects/heads/DialectNames.hpp"

#include "dialects/Dialects.hpp"
#include "dialects/UrdfCorrection.hpp"
#include "dialects/heads/HeadDialects.hpp"

namespace naocal {
namespace {

void addHeads(std::vector<std::string>& names) {
  for (const HeadDialect& head : headDialects()) {
    names.emplace_back(head.name);
  }
}

} // namespace

std::vector<std::string> importedDialects() {
  std::vector<std::string> names = dialectNames();
  addHeads(names);
  return names;
}

std::vector<std::string> exportedDialects() {
  std::vector<std::string> names = dialectNames();
  names.emplace_back(urdfDialect);
  addHeads(names);
  return names;
}

} // namespace naocal
