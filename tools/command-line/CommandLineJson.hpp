#pragma once

#include <nlohmann/json_fwd.hpp>

namespace CLI {
class App;
}

namespace naocal {

/// A command line in JSON, of which manual pages and completions are made: name, description, usage, group, footer,
/// options (names, value, words, description, group, argument, required, list) and commands, which are alike.
nlohmann::json commandLineJson(const CLI::App& app);

} // namespace naocal
