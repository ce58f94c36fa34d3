#pragma once

#include "framework/Configuration.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

/// A file of the configuration as its mount serves it.
struct Configuration::Mounted {
  std::string name;
  std::string file;
  Part part = Part::none;
  Listener listener;
  std::set<std::string> unsaved; // top-level keys that no file shall get
  Overlay overlay;
  nlohmann::json published = nlohmann::json::object();
  std::map<std::string, nlohmann::json> changed; // top-level keys that differ from the files, and what those say
};

} // namespace naocal
