#include "runs/HistoryFile.hpp"

#include "io/FileVersion.hpp"
#include "runs/RunFile.hpp"
#include "runs/RunWording.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

using nlohmann::json;

namespace {

json runsJson(const RobotHistory& history) {
  json list = json::array();
  for (const HistoricRun& one : history.runs) {
    json run = runJson(one.run);
    run.erase("format");
    run.erase("version");
    run["id"] = one.run.id;
    run["words"] = describeOutcome(one);
    run["undone"] = one.undone ? json(formatTime(*one.undone)) : json();
    list.push_back(std::move(run));
  }
  return list;
}

json offsetJson(const RobotHistory& history, const HistoricOffset& one) {
  const HistoricRun& run = history.runs[one.run];
  json point{{"run", run.run.id},
             {"time", formatTime(run.run.time)},
             {"offset", one.offset.value},
             {"sigma", one.offset.sigma},
             {"compared", run.isCompared()}};
  if (one.change) {
    point["change"] = {{"since", history.runs[*one.since].run.id},
                       {"value", one.change->value},
                       {"sigma", one.change->sigma},
                       {"degreesOfFreedom", one.change->freedom},
                       {"pValue", one.change->chance},
                       {"pValueOfAllJoints", one.change->familyChance},
                       {"jump", one.change->isJump},
                       {"afterFall", one.afterFall},
                       {"words", formatChange(*one.change)}};
  }
  return point;
}

json jointsJson(const RobotHistory& history) {
  json joints = json::array();
  for (const auto& [joint, series] : history.joints) {
    json points = json::array();
    for (const HistoricOffset& one : series) {
      points.push_back(offsetJson(history, one));
    }
    joints.push_back({{"joint", joint}, {"sentence", describeJoint(history, joint)}, {"offsets", std::move(points)}});
  }
  return joints;
}

} // namespace

json historyJson(const std::vector<RobotHistory>& histories, const std::string& folder,
                 const std::vector<std::string>& broken) {
  json robots = json::array();
  for (const RobotHistory& history : histories) {
    json falls = json::array();
    for (const RunTime fall : history.falls) {
      falls.push_back(formatTime(fall));
    }
    robots.push_back({{"body", history.robot.body},
                      {"head", history.robot.head},
                      {"bodyId", history.robot.bodyId},
                      {"headId", history.robot.headId},
                      {"name", describeRobot(history.robot)},
                      {"sentence", describeHistory(history)},
                      {"runs", runsJson(history)},
                      {"falls", std::move(falls)},
                      {"joints", jointsJson(history)}});
  }
  return withFormat("naocal-history",
                    {{"rule", describeRule()}, {"folder", folder}, {"broken", broken}, {"robots", std::move(robots)}});
}

} // namespace naocal
