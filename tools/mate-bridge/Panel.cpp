#include "Panel.hpp"

#include "Guard.hpp"
#include "LabDesk.hpp"
#include "Robots.hpp"
#include "Server.hpp"
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
                [this](std::size_t panel, const std::string& text) { received(panel, text); }}} {
    signals.async_wait([this](boost::system::error_code, int) { context.stop(); });
    for (const std::string& robot : options.robots) {
      robots.connect(robot);
    }
    if (options.opened) {
      desk.emplace(std::move(*options.opened), [this](const std::string& kind, std::string json) {
        boost::asio::post(context, [this, kind, told = message(std::move(json))] {
          if (kind != "refused") {
            latest[kind] = told;
          }
          server.sendAll(told);
        });
      });
    }
  }

  Robots::Calls robotCalls() {
    return {
        [this](const std::string& json) { server.sendAll(message(json)); },
        [this](std::size_t panel, const std::string& json) { server.send(panel, message(json)); },
        [this](std::size_t panel, std::string json) { server.send(panel, message(std::move(json), false, true)); },
        [this](std::size_t panel, std::string bytes) { server.send(panel, message(std::move(bytes), true, true)); }};
  }

  Answer file(std::string_view path) const {
    constexpr std::string_view pictures = "picture/";
    if (path.starts_with(pictures)) {
      auto picture = desk ? desk->picture(path.substr(pictures.size())) : std::nullopt;
      return picture ? Answer{200, "application/octet-stream", std::move(*picture)}
                     : plain(404, "This picture was not kept.");
    }
    if (const auto part = pageFile(path.empty() ? "index.html" : path)) {
      return {200, std::string{part->type}, std::string{part->content}};
    }
    return path.empty() ? plain(503, std::string{pageMissing()}) : plain(404, "The panel has no such file.");
  }

  void greet(std::size_t panel) {
    server.send(panel, message(Json{{"kind", "hello"}, {"laboratory", desk.has_value()}}.dump()));
    for (const auto& [kind, told] : latest) {
      server.send(panel, told);
    }
    robots.greet(panel);
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
      if (robots.asked(panel, request) || (desk && desk->asked(request))) {
        return;
      }
      problem = fmt::format("the bridge does not know how to do \"{}\"", request.at("do").get<std::string>());
    } catch (const InputError& error) {
      problem = error.what();
    } catch (const Json::exception& error) {
      problem = fmt::format("the bridge did not understand the panel: {}", error.what());
    }
    const Json refused{{"kind", "refused"}, {"sentence", problem}};
    server.send(panel, message(refused.dump(-1, ' ', false, Json::error_handler_t::replace)));
  }

  boost::asio::io_context context;
  boost::asio::signal_set signals;
  std::map<std::string, Message> latest; // what the laboratory told, by kind: for panels to come
  Robots robots;
  Server server;
  std::optional<LabDesk> desk; // ends first: its thread posts to the context
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
