#pragma once

#include "protocol/BoundedJson.hpp"

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace naocal {

/// An input's lines, each a message of a page to the bridge, with what they hold; null where that is no JSON.
inline std::vector<std::pair<std::string, nlohmann::json>> pageMessages(std::string_view bytes) {
  std::vector<std::pair<std::string, nlohmann::json>> messages;
  std::istringstream lines{std::string{bytes}};
  for (std::string line; std::getline(lines, line);) {
    nlohmann::json content;
    try {
      content = parseBoundedJson(line);
    } catch (const nlohmann::json::exception&) { // the bridge has to refuse it
    }
    messages.emplace_back(line, std::move(content));
  }
  return messages;
}

} // namespace naocal
