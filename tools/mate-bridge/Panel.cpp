#include "Panel.hpp"

#include "CommandRunner.hpp"
#include "analysis/AnalysisWorker.hpp"
#include "io/InputError.hpp"
#include "robot/FloorScene.hpp"
#include "robot/Robots.hpp"
#include "server/HttpServer.hpp"
#include "server/PageFiles.hpp"
#include "server/RequestGuard.hpp"
#include "server/Wire.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

HttpReply plain(unsigned status, std::string sentence) {
  return {status, "text/plain; charset=utf-8", std::move(sentence) + "\n"};
}

} // namespace

struct Panel::Implementation {
  explicit Implementation(PanelOptions options)
      : signals{context, SIGINT, SIGTERM}, robots{context, robotCalls()},
        server{context,
               options.port,
               makeToken(),
               {[this](std::string_view path) { return file(path); }, [this](std::size_t panel) { greet(panel); },
                [this](std::size_t panel) { robots.removePanel(panel); },
                [this](std::size_t panel, const std::string& text) { received(panel, text); }}},
        runner{context, findNaocal(), [this](const std::string& json) { server.sendAll(makeMessage(json)); }} {
    signals.async_wait([this](boost::system::error_code, int) { context.stop(); });
    for (const std::string& robot : options.robots) {
      robots.connect(robot);
    }
    if (options.opened) {
      analysis.setDataset(std::move(*options.opened));
    }
  }

  Message hello() const {
    const Json hello{{"kind", "hello"}, {"laboratory", analysis.worker() != nullptr}, {"robots", robots.addresses()}};
    return makeMessage(wireText(hello));
  }

  PanelCallbacks robotCalls() {
    return {
        [this](const std::string& json) { server.sendAll(makeMessage(json)); },
        [this](std::size_t panel, const std::string& json) { server.send(panel, makeMessage(json)); },
        [this](std::size_t panel, std::string json) { server.send(panel, makeMessage(std::move(json), false, true)); },
        [this](std::size_t panel, std::string bytes) { server.send(panel, makeMessage(std::move(bytes), true, true)); },
        [this](std::function<void()> action) { boost::asio::post(context, std::move(action)); }};
  }

  HttpReply file(std::string_view path) const {
    try {
      return fileThere(path);
    } catch (const std::exception& error) {
      return plain(500, error.what());
    }
  }

  HttpReply fileThere(std::string_view path) const {
    const AnalysisWorker* const worker = analysis.worker();
    path = path.substr(0, path.find('?')); // behind it stands only what keeps the browser from an older picture
    constexpr std::string_view pictures = "picture/";
    if (path.starts_with(pictures)) {
      auto picture = worker ? worker->picture(decodePercents(path.substr(pictures.size()))) : std::nullopt;
      return picture ? HttpReply{200, "application/octet-stream", std::move(*picture)}
                     : plain(404, "This picture was not kept.");
    }
    constexpr std::string_view taken = "taken/";
    if (path.starts_with(taken)) {
      auto picture = robots.takenPicture(decodePercents(path.substr(taken.size())));
      return picture ? HttpReply{200, "application/octet-stream", std::move(*picture)}
                     : plain(404, "Nobody saw this capture's picture.");
    }
    constexpr std::string_view made = "made/";
    if (path.starts_with(made)) {
      auto content = worker ? worker->generatedFile(std::string{path.substr(made.size())}) : std::nullopt;
      return content ? HttpReply{200, "application/octet-stream", std::move(*content)}
                     : plain(404, "This was not made.");
    }
    if (const auto part = pageFile(path.empty() ? "index.html" : path)) {
      return {200, std::string{part->type}, std::string{part->content}};
    }
    return path.empty() ? plain(503, std::string{pageMissing()}) : plain(404, "The panel has no such file.");
  }

  void refuse(std::size_t panel, const std::string& problem) {
    server.send(panel, makeMessage(wireText({{"kind", "refused"}, {"sentence", problem}})));
  }

  void greet(std::size_t panel) {
    server.send(panel, hello());
    for (const auto& [kind, told] : analysis.latest()) {
      server.send(panel, told);
    }
    robots.addPanel(panel);
    server.send(panel, makeMessage(runner.latest()));
  }

  void received(std::size_t panel, const std::string& text) {
    std::string problem;
    try {
      const Json request = wireJson(text);
      const auto found = handlers().find(request.at("do").get<std::string>());
      found == handlers().end() ? refuseVerb(request) : found->second(*this, panel, request);
      return;
    } catch (const Json::exception& error) {
      problem = fmt::format("the bridge did not understand the panel: {}", error.what());
    } catch (const std::exception& error) {
      problem = error.what();
    }
    refuse(panel, problem);
  }

  using Handler = std::function<void(Implementation& bridge, std::size_t panel, const Json& request)>;
  using Handlers = std::map<std::string, Handler, std::less<>>;

  /// Everything that a panel can ask for, by {"do": verb}. Handlers throw InputError for what cannot be done.
  static const Handlers& handlers() {
    static const Handlers all{
        // the bridge itself
        {"open",
         [](Implementation& bridge, std::size_t panel, const Json& request) {
           bridge.analysis.open(request.at("paths"),
                                [&bridge, panel](const std::string& why) { bridge.refuse(panel, why); });
         }},
        {"stand", [](Implementation& bridge, std::size_t panel,
                     const Json& request) { bridge.server.send(panel, makeMessage(bridge.stood(request).dump())); }},
        {"run",
         [](Implementation& bridge, std::size_t, const Json& request) { bridge.runner.run(request.at("words")); }},
        {"endRun", [](Implementation& bridge, std::size_t, const Json&) { bridge.runner.end(); }},
        // captures
        {"check",
         [](Implementation& bridge, std::size_t panel, const Json& request) {
           Json answer = bridge.worker(request).checkEffect(request.at("effect"));
           answer["kind"] = "checked";
           answer["number"] = request.at("number");
           bridge.server.send(panel, makeMessage(wireText(answer)));
         }},
        {"add", [](Implementation& bridge, std::size_t,
                   const Json& request) { bridge.worker(request).add(request.at("label")); }},
        {"drop", [](Implementation& bridge, std::size_t,
                    const Json& request) { bridge.worker(request).drop(request.at("label")); }},
        {"goTo", [](Implementation& bridge, std::size_t,
                    const Json& request) { bridge.worker(request).goTo(request.at("rung")); }},
        {"define", [](Implementation& bridge, std::size_t,
                      const Json& request) { bridge.worker(request).defineEffect(request.at("effect")); }},
        {"search",
         [](Implementation& bridge, std::size_t, const Json& request) { bridge.worker(request).searchMissing(); }},
        {"cancel",
         [](Implementation& bridge, std::size_t, const Json& request) { bridge.worker(request).cancelSearch(); }},
        {"propose", [](Implementation& bridge, std::size_t,
                       const Json& request) { bridge.worker(request).proposePoses(request.at("count")); }},
        {"compare", [](Implementation& bridge, std::size_t,
                       const Json& request) { bridge.worker(request).compareWith(request.at("paths")); }},
        {"make", [](Implementation& bridge, std::size_t,
                    const Json& request) { bridge.worker(request).generateFile(request.at("file")); }},
        // robots
        {"connect",
         [](Implementation& bridge, std::size_t, const Json& request) { bridge.robots.connect(request.at("robot")); }},
        {"disconnect",
         [](Implementation& bridge, std::size_t, const Json& request) {
           bridge.robot(request);
           bridge.robots.disconnect(request.at("robot"));
         }},
        {"watch",
         [](Implementation& bridge, std::size_t panel, const Json& request) { bridge.robot(request).watch(panel); }},
        {"unwatch",
         [](Implementation& bridge, std::size_t panel, const Json& request) {
           if (WatchedRobot* const robot = bridge.robots.find(request.at("robot"))) { // else it went with its robot
             robot->unwatch(panel);
           }
         }},
        {"subscribe", [](Implementation& bridge, std::size_t panel,
                         const Json& request) { bridge.robot(request).subscribe(request.at("key"), panel); }},
        {"unsubscribe",
         [](Implementation& bridge, std::size_t panel, const Json& request) {
           if (WatchedRobot* const robot = bridge.robots.find(request.at("robot"))) {
             robot->unsubscribe(request.at("key"), panel);
           }
         }},
        {"keys", [](Implementation& bridge, std::size_t,
                    const Json& request) { bridge.robot(request).requestKeys(request.at("mount")); }},
        {"set", [](Implementation& bridge, std::size_t,
                   const Json& request) { bridge.robot(request).set(request.at("settings")); }},
        {"save", [](Implementation& bridge, std::size_t, const Json& request) { bridge.robot(request).save(); }},
    };
    return all;
  }

  [[noreturn]] static void refuseVerb(const Json& request) {
    throw InputError{fmt::format("the bridge does not know how to do \"{}\"", request.at("do").get<std::string>())};
  }

  /// Throws InputError where no captures are open.
  AnalysisWorker& worker(const Json& request) const {
    AnalysisWorker* const worker = analysis.worker();
    if (!worker) {
      refuseVerb(request);
    }
    return *worker;
  }

  /// Throws InputError where that robot is not connected to.
  WatchedRobot& robot(const Json& request) const { return robots.at(request.at("robot"), request.at("do")); }

  /// How a robot would stand: {"angles": by joint or in HULKs' order [rad]} answered with "stand" and its number.
  Json stood(const Json& request) const {
    const Json& given = request.at("angles");
    const auto angles = given.is_array() ? parseOrderedAngles(given, drawing) : parseNamedAngles(given, drawing);
    Json answer = angles ? RobotOutline{drawing, *angles}.toJson({}) : Json::object();
    answer["kind"] = "stand";
    answer["number"] = request.at("number");
    return answer;
  }

  const Robot drawing = loadRobot(configurationDirectory(), "V6");
  boost::asio::io_context context;
  boost::asio::signal_set signals;
  Robots robots;
  HttpServer server;
  CommandRunner runner;
  AnalysisSlot analysis{[this](std::function<void()> action) { boost::asio::post(context, std::move(action)); },
                        [this](const Message& told) { server.sendAll(told); }}; // last: its threads post to the context
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
