#include "writer/Writing.hpp"

#include "seal/Seal.hpp"
#include "writer/Noncentrality.hpp"
#include "writer/Question.hpp"
#include "writer/Rendering.hpp"
#include "writer/SetFile.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace blind {

namespace {

using nlohmann::json;

json effectsJson(const Question& question) {
  json effects = json::array();
  for (const HiddenFlaw& hidden : question.hidden) {
    json unknowns = json::object();
    for (std::size_t i = 0; i < hidden.values.size(); ++i) {
      const FlawFamily::Unknown& unknown = hidden.family->unknowns[i];
      unknowns[unknown.name] = {{"value", hidden.values[i]}, {"unit", unknown.unit}};
    }
    if (hidden.family->effect == "gearPlay") { // the catalogue's t is relative to 0.2 Nm
      const int joint = question.robot.drawing->joint(hidden.place);
      const double friction = question.robot.flaws.joints[static_cast<std::size_t>(joint)].gapFriction;
      unknowns["t"] = {{"value", friction - 0.2}, {"unit", "Nm"}};
    }
    effects.push_back({{"effect", hidden.family->effect},
                       {"at", hidden.place},
                       {"unknowns", std::move(unknowns)},
                       {"noncentrality", hidden.noncentrality},
                       {"kept", hidden.kept}});
    if (!hidden.family->drivers.empty()) {
      effects.back()["drivers"] = driversAt(hidden);
    }
  }
  return effects;
}

json truthOf(const DesignItem& item, const Question& question, const std::string& name) {
  json offsets = json::object();
  for (std::size_t i = 0; i < question.robot.drawing->joints.size(); ++i) {
    offsets[question.robot.drawing->joints[i].name] = question.robot.offsets[static_cast<Eigen::Index>(i)];
  }
  json truth{{"format", "naocal-blind-truth"},
             {"version", 1},
             {"set", name},
             {"group", item.group},
             {"kind", item.kind},
             {"noise", item.noise},
             {"poses", item.poses},
             {"pictures", item.pictures},
             {"wanted", item.noncentrality},
             {"effects", effectsJson(question)},
             {"plausible", item.plausible},
             {"jitter", question.plan.noise.jitter},
             {"twins", question.twins},
             {"offsets", std::move(offsets)}};
  if (const auto happened = happening(question)) {
    truth["event"] = {{"what", happened->what},
                      {"at", happened->at},
                      {"before", happened->before},
                      {"after", happened->after},
                      {"by", happened->by}};
  }
  return truth;
}

} // namespace

std::string setName(int number) {
  return fmt::format("s{:06}", number);
}

void sealTruth(const std::string& truth, bool pictures, std::uint64_t seed, int number,
               const std::filesystem::path& out) {
  const std::string name = setName(number);
  const std::filesystem::path keyFile = out / "truth" / "key";
  const std::string key = sha256Hex(fmt::format("blind benchmark {}", seed));
  if (!std::filesystem::exists(keyFile)) {
    writeFile(keyFile, key);
  }
  const std::string bytes = seal(truth, key);
  writeFile(out / "truth" / (name + ".sealed"), bytes);
  const json manifest{{"format", "naocal-blind-manifest"},
                      {"version", 1},
                      {"set", name},
                      {"pictures", pictures},
                      {"truthSha256", sha256Hex(bytes)}};
  writeFile(out / "manifest" / (name + ".json"), manifest.dump(1) + "\n");
}

void writeItem(const Drawing& drawing, const DesignItem& item, std::uint64_t seed, int number,
               const std::filesystem::path& out) {
  const std::string name = setName(number);
  const std::string own = fmt::format("{} {}", seed, name);
  RandomStream chance{seed, own + " question"}, noise{seed, own + " noise"}, mistakes{seed, own + " mistakes"};
  Question question = drawQuestion(drawing, item, chance);
  corruptSession(item.kind, question.session, mistakes);

  const ObservedCorners seen =
      noisyCorners(TruePictures{question.robot, question.session}, question.session, question.plan.noise, noise);
  json set = captureSetJson(drawing, question.session, seen, item.pictures, name);
  json truth = truthOf(item, question, name);
  if (item.group == "corrupted") {
    truth["corruption"] = corruptFile(item.kind, question.plan.mainSide, set, mistakes);
  }
  if (item.pictures) {
    renderSession(question.robot, question.session, noise, out / "sets" / name);
  }
  writeFile(out / "sets" / name / "captures.json", set.dump() + "\n");

  const Session later = lockedSession(question, chance);
  const ObservedCorners seenLater =
      noisyCorners(TruePictures{question.robot, later}, later, question.plan.noise, noise);
  truth["lockedFloorPx"] = noiseFloor(question.robot, later, seenLater);
  writeFile(out / "locked" / name / "captures.json",
            captureSetJson(drawing, later, seenLater, false, name).dump() + "\n");

  sealTruth(truth.dump(1), item.pictures, seed, number, out);
}

} // namespace blind
