#include "Panel.hpp"

#include "Errand.hpp"
#include "Guard.hpp"
#include "LabDesk.hpp"
#include "Robots.hpp"
#include "Server.hpp"
#include "StandingRobot.hpp"
#include "Wire.hpp"
#include "page/Page.hpp"

#include "captures/InputError.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

Message message(std::string bytes, bool binary = false, bool skippable = false) {
  return {std::make_shared<const std::string>(std::move(bytes)), binary, skippable};
}

Answer plain(unsigned status, std::string sentence) {
  return {status, "text/plain; charset=utf-8", std::move(sentence) + "\n"};
}

} // namespace

struct Panel::Implementation {
  explicit Implementation(PanelOptions options)
      : signals{context, SIGINT, SIGTERM}, robots{context, robotCalls()},
        server{context,
               options.port,
               newToken(),
               {[this](std::string_view path) { return file(path); }, [this](std::size_t panel) { greet(panel); },
                [this](std::size_t panel) { robots.forget(panel); },
                [this](std::size_t panel, const std::string& text) { received(panel, text); }}},
        errand{context, naocalProgram(), [this](const std::string& json) { server.sendAll(message(json)); }} {
    signals.async_wait([this](boost::system::error_code, int) { context.stop(); });
    for (const std::string& robot : options.robots) {
      robots.connect(robot);
    }
    if (options.opened) {
      open(std::move(*options.opened));
    }
  }

  /// Puts captures on the laboratory's desk, in place of those that lie there.
  void open(OpenedSets opened) {
    const std::size_t number = desks + 1;
    auto fresh =
        std::make_unique<LabDesk>(std::move(opened), [this, number](const std::string& kind, std::string json) {
          boost::asio::post(context, [this, number, kind, told = message(std::move(json))] {
            if (number != desks) {
              return; // the desk was cleared since
            }
            if (kind != "refused" && kind != "made") {
              latest[kind] = told;
            }
            server.sendAll(told);
          });
        });
    desks = number;
    latest.clear();
    server.sendAll(message(R"({"kind": "opened"})"));
    desk = std::move(fresh);
  }

  Message hello() const { return message(Json{{"kind", "hello"}, {"laboratory", desk != nullptr}}.dump()); }

  RobotsCalls robotCalls() {
    return {[this](const std::string& json) { server.sendAll(message(json)); },
            [this](std::size_t panel, const std::string& json) { server.send(panel, message(json)); },
            [this](std::size_t panel, std::string json) { server.send(panel, message(std::move(json), false, true)); },
            [this](std::size_t panel, std::string bytes) { server.send(panel, message(std::move(bytes), true, true)); },
            [this](std::function<void()> action) { boost::asio::post(context, std::move(action)); }};
  }

  Answer file(std::string_view path) const {
    constexpr std::string_view pictures = "picture/";
    if (path.starts_with(pictures)) {
      auto picture = desk ? desk->picture(path.substr(pictures.size())) : std::nullopt;
      return picture ? Answer{200, "application/octet-stream", std::move(*picture)}
                     : plain(404, "This picture was not kept.");
    }
    constexpr std::string_view made = "made/";
    if (path.starts_with(made)) {
      auto content = desk ? desk->made(std::string{path.substr(made.size())}) : std::nullopt;
      return content ? Answer{200, "application/octet-stream", std::move(*content)} : plain(404, "This was not made.");
    }
    if (const auto part = pageFile(path.empty() ? "index.html" : path)) {
      return {200, std::string{part->type}, std::string{part->content}};
    }
    return path.empty() ? plain(503, std::string{pageMissing()}) : plain(404, "The panel has no such file.");
  }

  void greet(std::size_t panel) {
    server.send(panel, hello());
    for (const auto& [kind, told] : latest) {
      server.send(panel, told);
    }
    robots.greet(panel);
    server.send(panel, message(errand.latest()));
  }

  void received(std::size_t panel, const std::string& text) {
    std::string problem;
    try {
      const Json request = Json::parse(text);
      if (request.at("do") == "check" && desk) {
        Json answer = desk->checked(request.at("effect"));
        answer["kind"] = "checked";
        answer["number"] = request.at("number");
        server.send(panel, message(answer.dump()));
        return;
      }
      if (request.at("do") == "open") {
        open(openSets(request.at("paths").get<std::vector<std::string>>()));
        return;
      }
      if (request.at("do") == "stand") {
        server.send(panel, message(stood(request).dump()));
        return;
      }
      if (robots.asked(panel, request) || (desk && desk->asked(request)) || errand.asked(request)) {
        return;
      }
      problem = fmt::format("the bridge does not know how to do \"{}\"", request.at("do").get<std::string>());
    } catch (const InputError& error) {
      problem = error.what();
    } catch (const Json::exception& error) {
      problem = fmt::format("the bridge did not understand the panel: {}", error.what());
    }
    const Json refused{{"kind", "refused"}, {"sentence", problem}};
    server.send(panel, message(wireText(refused)));
  }

  /// How a robot would stand: {"angles": by joint or in HULKs' order [rad]} answered with "stand" and its number.
  Json stood(const Json& request) const {
    const Json& given = request.at("angles");
    const auto angles = given.is_array() ? anglesInOrder(given, drawing) : anglesByName(given, drawing);
    Json answer = angles ? StandingRobot{drawing, *angles}.drawn({}) : Json::object();
    answer["kind"] = "stand";
    answer["number"] = request.at("number");
    return answer;
  }

  const Robot drawing = loadRobot(configurationDirectory(), "V6");
  boost::asio::io_context context;
  boost::asio::signal_set signals;
  std::map<std::string, Message> latest; // what the laboratory told, by kind: for panels to come
  Robots robots;
  Server server;
  Errand errand;
  std::size_t desks = 0;         // that there were
  std::unique_ptr<LabDesk> desk; // ends first: its thread posts to the context
};

Panel::Panel(PanelOptions options) : implementation_{std::make_unique<Implementation>(std::move(options))} {}
Panel::~Panel() = default;

std::string Panel::address() const {
  return implementation_->server.address();
}

void Panel::run() {
  implementation_->context.run();
}

void Panel::stop() {
  implementation_->context.stop();
}

} // namespace naocal
