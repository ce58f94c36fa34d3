#pragma once

#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>

namespace boost::asio {
class io_context;
}

namespace naocal {

class RobotLink;

/// The robots that panels look at, by address. A key is subscribed to as long as some panel shows it.
class Robots {
public:
  struct Calls {
    std::function<void(const std::string& json)> all;                        // for every panel
    std::function<void(std::size_t panel, const std::string& json)> one;     // for one
    std::function<void(std::size_t panel, std::string json)> update;         // live values, skippable
    std::function<void(std::size_t panel, std::string headAndFile)> picture; // "{json}\n" and the file, skippable
  };
  Robots(boost::asio::io_context& context, Calls calls);
  ~Robots();

  /// Throws InputError for an address that cannot be one.
  void connect(const std::string& address);

  /// Does what a panel asks for: {"do": "connect" | "disconnect", "robot"}, {"do": "subscribe" | "unsubscribe",
  /// "robot", "key"}, {"do": "keys", "robot", "mount"}, {"do": "set", "robot", "settings"}, {"do": "save", "robot"}.
  /// False: that is nothing for robots.
  bool asked(std::size_t panel, const nlohmann::json& request);

  /// What a panel that has just come must know.
  void greet(std::size_t panel) const;
  /// A panel has gone.
  void forget(std::size_t panel);

private:
  struct Entry;
  void disconnect(const std::string& address);
  void change(std::size_t panel, Entry& entry, const std::string& verb, const nlohmann::json& request);
  std::string state(const std::string& address, const Entry& entry) const;
  void listed(const std::string& address, const std::string& kind, const std::string& body);
  void updated(const std::string& address, const std::string& body);
  void pictured(const std::string& address, const std::string& body);

  boost::asio::io_context& context_;
  Calls calls_;
  std::map<std::string, std::unique_ptr<Entry>> entries_;
};

} // namespace naocal
