#include "fuzz/driver/Reader.hpp"

namespace naocal {
namespace {

std::vector<const Reader*>& registered() {
  static std::vector<const Reader*> readers;
  return readers;
}

} // namespace

Reader::Reader(std::string name, Read read, int longest) : name_{std::move(name)}, read_{read}, longest_{longest} {
  registered().push_back(this);
}

const std::vector<const Reader*>& Reader::all() {
  return registered();
}

} // namespace naocal
