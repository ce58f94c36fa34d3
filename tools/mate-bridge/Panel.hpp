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
  std::optional<Dataset> opened;   // initial dataset; absent: none
  std::vector<std::string> robots; // initial robots: addresses
  std::uint16_t port = 0;          // on 127.0.0.1; 0: any free one
};

/// The complete bridge: server, analysis of captures, robots. Runs until `stop`.
class Panel {
public:
  explicit Panel(PanelOptions options);
  ~Panel();

  /// URL of the panel, including the token.
  std::string address() const;

  void run();
  /// Thread-safe.
  void stop();

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace naocal
