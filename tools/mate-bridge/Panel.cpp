#include "Panel.hpp"

#include "CommandRunner.hpp"
#include "PanelHistory.hpp"
#include "analysis/AnalysisWorker.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "io/Programs.hpp"
#include "protocol/BoundedJson.hpp"
#include "protocol/JointOrder.hpp"
#include "robot/FloorScene.hpp"
#include "robot/Robots.hpp"
#include "server/HttpServer.hpp"
#include "server/PageFiles.hpp"
#include "server/RequestGuard.hpp"
#include "start/StartPage.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <fmt/format.h>
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
                [this](std::size_t panel) {
                  robots.removePanel(panel);
                  start.removePanel(panel);
                },
                [this](std::size_t panel, const std::string& text) { received(panel, text); }}},
        runner{context, findProgram("naocal"), [this](const std::string& json) { server.sendAll(makeMessage(json)); }},
        start{context, options.recentFiles, startCalls()}, lookIn{std::move(options.lookIn)}, history{std::move(
                                                                                                          options.runs),
                                                                                                      historyCalls()} {
    signals.async_wait([this](boost::system::error_code, int) { context.stop(); });
    for (const std::string& robot : options.robots) {
      robots.connect(robot);
    }
    if (options.opened) {
      analysis.setDataset(std::move(*options.opened));
      start.opened(options.paths);
    }
  }

  Message hello() const {
    const Json hello{{"kind", "hello"},
                     {"analysis", analysis.worker() != nullptr},
                     {"robots", robots.addresses()},
                     {"joints", jointNames}}; // order of per-joint lists in robots' messages
    return makeMessage(jsonText(hello));
  }

  PanelCallbacks robotCalls() {
    return {
        [this](const std::string& json) { server.sendAll(makeMessage(json)); },
        [this](std::size_t panel, const std::string& json) { server.send(panel, makeMessage(json)); },
        [this](std::size_t panel, std::string json) { server.send(panel, makeMessage(std::move(json), false, true)); },
        [this](std::size_t panel, std::string bytes) { server.send(panel, makeMessage(std::move(bytes), true, true)); },
        [this](std::function<void()> action) { boost::asio::post(context, std::move(action)); },
        [this](const std::string& robot, const Json& runs) { history.record(robot, runs); }};
  }

  PanelHistory::Callbacks historyCalls() {
    return {[this](std::function<void()> action) { boost::asio::post(context, std::move(action)); },
            [this](const Json& message) { server.sendAll(makeMessage(jsonText(message))); },
            [this](const std::vector<std::string>& paths, const std::vector<std::filesystem::path>& folders) {
              analysis.open(
                  paths, [this](const std::string& why) { refuseAll(why); }, [] {}, folders);
            }};
  }

  StartPage::Calls startCalls() {
    return {[this](const std::string& json) { server.sendAll(makeMessage(json)); },
            [this](std::size_t panel, const std::string& json) { server.send(panel, makeMessage(json)); },
            [this](const std::vector<std::string>& paths, std::function<void(const std::string& why)> refused,
                   std::function<void()> opened) {
              if (!refused) {
                refused = [this](const std::string& why) { refuseAll(why); };
              }
              analysis.open(paths, std::move(refused), std::move(opened), lookIn);
            },
            [this](const std::string& robot) { robots.connect(robot); },
            [this](const std::string& robot) { robots.disconnect(robot); }};
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
    path = path.substr(0, path.find('?')); // the query only prevents caching
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
                     : HttpReply{204, "application/octet-stream", {}}; // gone to a capture nearer in time
    }
    constexpr std::string_view made = "made/";
    if (path.starts_with(made)) {
      auto content = worker ? worker->generatedFile(std::string{path.substr(made.size())}) : std::nullopt;
      return content ? HttpReply{200, "application/octet-stream", std::move(*content)}
                     : plain(404, "This was not made.");
    }
    if (auto boards = StartPage::boards(path)) {
      return {200, "application/pdf", std::move(*boards)};
    }
    if (const auto part = pageFile(path.empty() ? "index.html" : path)) {
      return {200, std::string{part->type}, std::string{part->content}};
    }
    return path.empty() ? plain(503, std::string{pageMissing()}) : plain(404, "The panel has no such file.");
  }

  static Message refusal(const std::string& problem, const Json& number = nullptr) {
    return makeMessage(jsonText({{"kind", "refused"}, {"sentence", problem}, {"number", number}}));
  }
  /// `number`: that of the panel's request, if it has one.
  void refuse(std::size_t panel, const std::string& problem, const Json& number = nullptr) {
    server.send(panel, refusal(problem, number));
  }
  void refuseAll(const std::string& problem) { server.sendAll(refusal(problem)); }

  /// The folders of the request's `lookIn`, then those of the program's options.
  std::vector<std::filesystem::path> foldersToSearch(const Json& request) const {
    const auto named = request.value("lookIn", std::vector<std::string>{});
    std::vector<std::filesystem::path> folders{named.begin(), named.end()};
    folders.insert(folders.end(), lookIn.begin(), lookIn.end());
    return folders;
  }

  /// Sends a new panel all that it shows.
  void greet(std::size_t panel) {
    try {
      sendAll(panel);
    } catch (const std::exception& error) {
      refuse(panel, error.what());
    }
  }

  void sendAll(std::size_t panel) {
    server.send(panel, hello());
    for (const auto& [kind, told] : analysis.latest()) {
      server.send(panel, told);
    }
    robots.addPanel(panel);
    server.send(panel, makeMessage(runner.latest()));
    server.send(panel, makeMessage(start.message()));
    if (history.isRecording()) {
      history.refresh();
    }
  }

  void received(std::size_t panel, const std::string& text) {
    std::string problem;
    Json number;
    try {
      const std::size_t end = std::min(text.find('\n'), text.size()); // of the JSON; a part of a file may follow
      const Json body = parseBoundedJson(std::string_view{text}.substr(0, end));
      number = body.value("number", Json{});
      const Request request{*this, panel, body, std::string_view{text}.substr(std::min(end + 1, text.size()))};
      const auto found = handlers().find(request.verb());
      found == handlers().end() ? request.refuseVerb() : found->second(request);
      return;
    } catch (const Json::exception& error) {
      problem = fmt::format("the bridge did not understand the panel: {}", error.what());
    } catch (const std::exception& error) {
      problem = error.what();
    }
    refuse(panel, problem, number);
  }

  /// A panel's request: {"do": verb, ..}; with a part of a file: "{json}\n" and its bytes.
  struct Request {
    Implementation& bridge;
    std::size_t panel;
    const Json& body;
    std::string_view attached;

    const Json& at(const char* key) const { return body.at(key); }
    std::string verb() const { return at("do"); }
    /// A whole number from 0 on; throws InputError for another value.
    int numberAt(const char* key) const { return JsonCursor{body, "the request"}.at(key).integer(0, maxInteger); }

    [[noreturn]] void refuseVerb() const {
      throw InputError{fmt::format("the bridge does not know how to do \"{}\"", verb())};
    }
    /// Throws InputError if no captures are open.
    AnalysisWorker& worker() const {
      AnalysisWorker* const worker = bridge.analysis.worker();
      if (!worker) {
        refuseVerb();
      }
      return *worker;
    }
    /// Throws InputError if the robot is not connected.
    WatchedRobot& robot() const { return bridge.robots.at(at("robot"), verb()); }
    /// nullptr if the robot is not connected any more.
    WatchedRobot* robotIfThere() const { return bridge.robots.find(at("robot")); }

    /// Replies to this panel, with the request's number.
    void answer(const char* kind, Json content) const {
      content["kind"] = kind;
      content["number"] = at("number");
      bridge.server.send(panel, makeMessage(jsonText(content)));
    }
    void open() const {
      const std::vector<std::string> paths = at("paths");
      bridge.analysis.open(
          paths, [&bridge = bridge, panel = panel](const std::string& why) { bridge.refuse(panel, why); },
          [&bridge = bridge, paths] { bridge.start.opened(paths); }, bridge.foldersToSearch(body));
    }
    void upload() const {
      bridge.start.beginUpload(panel, at("files"));
      answer("uploaded", {{"bytes", 0}, {"complete", false}});
    }
    void unwatch() const {
      if (WatchedRobot* const robot = robotIfThere()) {
        robot->unwatch(panel);
      }
    }
    void unsubscribe() const {
      if (WatchedRobot* const robot = robotIfThere()) {
        robot->unsubscribe(at("key"), panel);
      }
    }
    void disconnect() const {
      robot(); // throws if there is none
      bridge.robots.disconnect(at("robot"));
    }
  };

  /// All requests of a panel, by verb.
  using Handlers = std::map<std::string_view, void (*)(const Request& request)>;
  static const Handlers& handlers() {
    static const Handlers all{
        // captures
        {"open", [](const Request& request) { request.open(); }},
        {"check",
         [](const Request& request) { request.answer("checked", request.worker().checkEffect(request.at("effect"))); }},
        {"add", [](const Request& request) { request.worker().add(request.at("labels")); }},
        {"drop", [](const Request& request) { request.worker().drop(request.at("label")); }},
        {"goTo", [](const Request& request) { request.worker().goTo(request.numberAt("rung")); }},
        {"define", [](const Request& request) { request.worker().defineEffect(request.at("effect")); }},
        {"propose", [](const Request& request) { request.worker().proposePoses(request.numberAt("count")); }},
        {"compare", [](const Request& request) { request.worker().compareWith(request.at("paths")); }},
        {"history", [](const Request& request) { request.bridge.history.refresh(); }},
        {"openRun",
         [](const Request& request) {
           request.bridge.history.open(request.at("id"), request.bridge.foldersToSearch(request.body));
         }},
        {"make", [](const Request& request) { request.worker().generateFile(request.at("file")); }},
        // robots
        {"connect", [](const Request& request) { request.bridge.robots.connect(request.at("robot")); }},
        {"disconnect", [](const Request& request) { request.disconnect(); }},
        {"watch", [](const Request& request) { request.robot().watch(request.panel); }},
        {"unwatch", [](const Request& request) { request.unwatch(); }},
        {"subscribe", [](const Request& request) { request.robot().subscribe(request.at("key"), request.panel); }},
        {"unsubscribe", [](const Request& request) { request.unsubscribe(); }},
        {"keys", [](const Request& request) { request.robot().requestKeys(request.at("mount")); }},
        {"set", [](const Request& request) { request.robot().set(request.at("settings")); }},
        {"save", [](const Request& request) { request.robot().save(); }},
        {"stand", [](const Request& request) { request.answer("stand", request.bridge.stood(request.at("angles"))); }},
        // the start page
        {"forget", [](const Request& request) { request.bridge.start.forget(request.at("paths")); }},
        {"findRobots", [](const Request& request) { request.bridge.start.findRobots(request.at("robots")); }},
        {"sample", [](const Request& request) { request.bridge.start.openSample(); }},
        {"truth",
         [](const Request& request) {
           request.answer("truth", {{"label", request.bridge.start.sampleTruth()}});
         }},
        {"startRobot", [](const Request& request) { request.bridge.start.startRobot(); }},
        {"endRobot", [](const Request& request) { request.bridge.start.endRobot(); }},
        {"upload", [](const Request& request) { request.upload(); }},
        {"uploadPart",
         [](const Request& request) {
           request.answer("uploaded", request.bridge.start.addUpload(request.panel, request.attached));
         }},
        {"importChoose",
         [](const Request& request) { request.bridge.start.imports().choose(request.panel, request.at("choices")); }},
        {"importColumn",
         [](const Request& request) {
           request.bridge.start.imports().assign(request.panel, request.at("column"), request.at("meaning"),
                                                 request.at("unit"));
         }},
        {"importColumns",
         [](const Request& request) {
           request.bridge.start.imports().setColumns(request.panel, request.at("columns"));
         }},
        {"importWrite", [](const Request& request) { request.bridge.start.imports().write(request.panel); }},
        {"importEnd", [](const Request& request) { request.bridge.start.imports().end(request.panel); }},
        // the terminal's commands
        {"run", [](const Request& request) { request.bridge.runner.run(request.at("words")); }},
        {"endRun", [](const Request& request) { request.bridge.runner.end(); }},
    };
    return all;
  }

  /// Outline of the robot at joint angles [rad], given by name or in HULKs' order; empty if they are invalid.
  Json stood(const Json& given) const {
    const auto angles = given.is_array() ? parseOrderedAngles(given, drawing) : parseNamedAngles(given, drawing);
    return angles ? RobotOutline{drawing, *angles}.toJson({}) : Json::object();
  }

  const Robot drawing = loadRobot(configurationDirectory(), "V6");
  boost::asio::io_context context;
  boost::asio::signal_set signals;
  Robots robots;
  HttpServer server;
  CommandRunner runner;
  StartPage start;
  AnalysisSlot analysis{[this](std::function<void()> action) { boost::asio::post(context, std::move(action)); },
                        [this](const Message& told) { server.sendAll(told); }};
  const std::vector<std::filesystem::path> lookIn;
  PanelHistory history; // last, with `analysis`: their threads post to the context
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
