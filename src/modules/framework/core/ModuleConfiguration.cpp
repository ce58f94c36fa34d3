#include "framework/core/ModuleConfiguration.hpp"

#include "framework/configuration/Configuration.hpp"
#include "framework/configuration/ConfigurationLayers.hpp"
#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"
#include "framework/core/Thread.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <set>

namespace naocal {
namespace {

/// Calls `prepare`; adds mount and key to its ConfigurationError.
std::function<void()> prepareAt(AnyParameter& parameter, const nlohmann::json& value, const std::string& mount) {
  try {
    return parameter.prepare(value);
  } catch (const ConfigurationError& error) {
    throw ConfigurationError{fmt::format("{}: {}: {}", mount, parameter.key(), error.what())};
  }
}

void configureModule(Thread& thread, Module& module, Configuration& configuration, std::vector<std::string>& unknown) {
  const std::string mount = thread.name() + "." + module.name();
  const std::string file = module.name() + ".json";
  std::set<std::string> known, commands;
  for (const AnyParameter* parameter : module.parameters()) {
    known.insert(parameter->key());
    if (parameter->isCommand()) {
      commands.insert(parameter->key());
    }
  }
  const auto listener = [&thread, &module, mount](const auto& key, const auto& value) {
    for (AnyParameter* parameter : module.parameters()) {
      if (parameter->key() == key) {
        thread.postChange(module, *parameter, prepareAt(*parameter, value, mount));
      }
    }
  };
  configuration.mount(mount, file, thread.part(), listener, std::move(commands));
  nlohmann::json keys;
  configuration.readKeys(mount, keys);
  for (AnyParameter* parameter : module.parameters()) {
    const auto entry = keys.find(parameter->key());
    if (entry == keys.end()) {
      throw ConfigurationError{fmt::format("{}: the parameter {} is missing; add it to {} in a location of the "
                                           "configuration",
                                           mount, parameter->key(), file)};
    }
    prepareAt(*parameter, *entry, mount)();
  }
  for (const auto& [key, value] : keys.items()) {
    if (!known.contains(key)) {
      unknown.push_back(fmt::format("{}: {} has a key \"{}\" that means nothing there; known are {}", mount, file, key,
                                    fmt::join(known, ", ")));
    }
  }
}

} // namespace

std::vector<std::string> configureModules(Thread& thread, Configuration& configuration) {
  std::vector<std::string> unknown;
  for (const auto& module : thread.modules()) {
    if (!module->parameters().empty()) {
      configureModule(thread, *module, configuration, unknown);
    }
    module->onParametersChanged();
  }
  return unknown;
}

} // namespace naocal
