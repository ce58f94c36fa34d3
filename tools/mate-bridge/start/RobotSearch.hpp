#pragma once

#include "start/ChildProgram.hpp"

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// A robot that announces itself on the local network.
struct AnnouncedRobot {
  std::string name, address; // such as "nao21" and "10.1.24.21"
};

/// Robots in the output of `avahi-browse --resolve --parsable`: its lines "=;interface;IPv4;name;type;domain;host;
/// address;port;..". Other lines are ignored; every address is listed once.
std::vector<AnnouncedRobot> parseAnnouncements(const std::deque<std::string>& lines);

/// Looks for robots, once per request and for a few seconds: asks the listed addresses alone whether naocal listens
/// there, and lists NAOs that announce themselves by mDNS (`_nao._tcp`), with avahi-browse where it is installed.
/// Sends nothing to announced robots.
class RobotSearch {
public:
  static constexpr std::chrono::seconds longestAnswer{2}, longestBrowse{6};

  RobotSearch(boost::asio::io_context& context, std::function<void()> changed);
  ~RobotSearch();

  /// Starts a new search. Throws InputError for an address that cannot be one.
  void search(const std::vector<std::string>& addresses);
  /// {"searching", "searched": whether ever, "listed": [{"address", "state": "asking", "answers" or "silent",
  /// "sentence"}], "announced":
  /// [{"name", "address"}], "note": why announced robots cannot be listed, or empty}
  nlohmann::json state() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace naocal
