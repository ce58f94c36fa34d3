#include "command-line/CommandLineJson.hpp"

#include "command-line/HelpFormatter.hpp"
#include "command-line/OptionText.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

namespace naocal {

namespace {

nlohmann::json optionJson(const CLI::Option& option) {
  const OptionText text = describeOption(option);
  return {{"names", text.names},
          {"value", text.value},
          {"words", text.words},
          {"heading", text.heading()},
          {"description", text.description},
          {"group", text.group},
          {"argument", text.isArgument},
          {"required", text.isRequired},
          {"list", text.isList}};
}

nlohmann::json commandJson(const CLI::App& app, const std::string& words) {
  nlohmann::json json{{"name", app.get_name()},
                      {"words", words},
                      {"usage", usageLine(app, words)},
                      {"description", app.get_description()},
                      {"group", app.get_group()},
                      {"footer", app.get_footer()},
                      {"options", nlohmann::json::array()},
                      {"commands", nlohmann::json::array()}};
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_group().empty()) {
      json["options"].push_back(optionJson(*option));
    }
  }
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    json["commands"].push_back(commandJson(*command, words + " " + command->get_name()));
  }
  return json;
}

} // namespace

nlohmann::json commandLineJson(const CLI::App& app) {
  return commandJson(app, app.get_name());
}

} // namespace naocal
