#pragma once

#include "analysis/Dataset.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

struct PanelOptions {
  std::optional<Dataset> opened;   // what to analyse
  std::vector<std::string> robots; // addresses
  std::uint16_t port = 0;          // on 127.0.0.1; 0: any that is free
};

/// The whole bridge: server, analysis of captures, robots. Runs until `stop`.
class Panel {
public:
  explicit Panel(PanelOptions options);
  ~Panel();

  /// What a person opens; holds the token.
  std::string address() const;

  void run();
  /// From any thread.
  void stop();

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace naocal
