#include "framework/core/Database.hpp"
#include "framework/core/Module.hpp"
#include "framework/core/Thread.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

/// Adds one to its dependency; named after its production.
class Adder : public Module {
public:
  Adder(const std::string& produces, const std::string& needs)
      : Module{produces + "er"}, in_{*this, needs}, out_{*this, produces} {}
  void cycle() override { out_ = *in_ + 1; }

private:
  Dependency<int> in_;
  Production<int> out_;
};

class Source : public Module {
public:
  explicit Source(const std::string& name = "Source") : Module{name} {}
  void cycle() override {
    out_ = *out_ + 100;
    history_.edit().push(TimePoint{} + std::chrono::seconds{*out_}, *out_);
  }

private:
  Production<int> out_{*this, "number"};
  Production<History<double>> history_{*this, "numbers"};
};

template <class T> class Reader : public Module {
public:
  Reader(const std::string& name, const std::string& needs) : Module{name}, in_{*this, needs} {}
  void cycle() override {}
  const T& read() const { return *in_; }

private:
  Dependency<T> in_;
};

class Writer : public Module {
public:
  Writer() : Module{"Writer"} {}
  void cycle() override { latest_.edit().write(7); }

private:
  Production<Latest<int>> latest_{*this, "request"};
};

std::string wiringError(const std::vector<Thread*>& threads) {
  try {
    Database{threads};
  } catch (const WiringError& error) {
    return error.what();
  }
  return "wired";
}

} // namespace

TEST_CASE("modules run after those that they depend on, whatever order they were added in") {
  // Proves the computed order by the values of two cycles.
  Thread motion{"Motion", RobotPart::body};
  auto& last = motion.add<Reader<int>>("Reader", "c");
  motion.add<Adder>("c", "b");
  motion.add<Adder>("b", "a");
  motion.add<Adder>("a", "number");
  motion.add<Source>();
  const Database database{{&motion}};
  motion.cycle();
  CHECK(last.read() == 103);
  motion.cycle();
  CHECK(last.read() == 203);
  CHECK(database.find("Motion.c") != nullptr);
  CHECK(database.find("Motion.d") == nullptr);
}

TEST_CASE("modules that need nothing of each other keep the order in which they were added") {
  // Proves a deterministic order.
  Thread motion{"Motion", RobotPart::body};
  motion.add<Adder>("z", "number");
  motion.add<Adder>("a", "number");
  motion.add<Source>();
  const Database database{{&motion}};
  std::vector<std::string> names;
  for (const auto& module : motion.modules()) {
    names.push_back(module->name());
  }
  CHECK(names == std::vector<std::string>{"CycleClock", "Source", "zer", "aer"});
}

TEST_CASE("wiring errors are sentences with names") {
  // Pins the messages, which are read at start-up and must say what to do.
  Thread motion{"Motion", RobotPart::body};
  motion.add<Source>();
  SECTION("a dependency that nobody produces") {
    motion.add<Reader<int>>("Stillness", "speeds");
    CHECK(wiringError({&motion}) ==
          "Motion.Stillness needs Motion.speeds, which no module produces; add the module that "
          "does, or correct the name");
  }
  SECTION("two producers") {
    motion.add<Source>("Spring");
    CHECK(wiringError({&motion}) == "Motion.number is produced by two modules, Source and Spring; a value has one "
                                    "producer: rename or remove one of them");
  }
  SECTION("another type") {
    motion.add<Reader<float>>("Stillness", "number");
    CHECK(wiringError({&motion}) == "Motion.Stillness needs Motion.number as a value of another type than Source "
                                    "produces; make the two types equal");
  }
  SECTION("a circle") {
    motion.add<Adder>("a", "c");
    motion.add<Adder>("b", "a");
    motion.add<Adder>("c", "b");
    motion.add<Adder>("d", "c");
    CHECK(wiringError({&motion}) == "Motion: modules depend on each other in a circle: aer needs cer, which needs ber, "
                                    "which needs aer; none can be the first");
  }
  SECTION("a module that depends on itself") {
    motion.add<Adder>("a", "a");
    CHECK(wiringError({&motion}) ==
          "Motion: modules depend on each other in a circle: aer needs aer; none can be the first");
  }
}

TEST_CASE("only a history or a latest value is read by another thread") {
  // Proves which productions may cross threads, the message for others, and that a Latest has one reader.
  Thread motion{"Motion", RobotPart::body}, brain{"Brain", RobotPart::head};
  motion.add<Source>();
  motion.add<Writer>();
  SECTION("they may") {
    auto& numbers = brain.add<Reader<History<double>>>("Images", "Motion.numbers");
    auto& request = brain.add<Reader<Latest<int>>>("Player", "Motion.request");
    const Database database{{&motion, &brain}};
    motion.cycle();
    CHECK(numbers.read().newest()->value == 100);
    CHECK(*request.read().take() == 7);
  }
  SECTION("a plain value may not") {
    brain.add<Reader<int>>("Images", "Motion.number");
    CHECK(wiringError({&motion, &brain}) ==
          "Brain.Images needs Motion.number, which is computed by another thread while it is read; only a History or a "
          "Latest can be read by another thread");
  }
  SECTION("a latest value has one reader") {
    brain.add<Reader<Latest<int>>>("Player", "Motion.request");
    brain.add<Reader<Latest<int>>>("Other", "Motion.request");
    CHECK(wiringError({&motion, &brain}) == "Motion.request is a Latest, which one module takes from, and Brain.Player "
                                            "and Brain.Other both do; give each its own");
  }
}

TEST_CASE("a thread counts its cycles and tells its listener what was edited in each") {
  // Proves the cycle counts and the listener's view; only plausibility of the measured times is tested.
  struct Listener : CycleListener {
    void onCycleEnd(TimePoint, const std::vector<AnyProduction*>& productions) override {
      for (const AnyProduction* production : productions) {
        edited += production->name() + (production->wasEdited() ? "! " : " ");
      }
    }
    std::string edited;
  };
  Thread motion{"Motion", RobotPart::body};
  motion.add<Source>();
  auto& times = motion.add<Reader<CycleTimes>>("Reader", "cycleTimes");
  const Database database{{&motion}};
  motion.cycle();
  Listener listener;
  motion.setListener(listener);
  motion.cycle();
  CHECK(listener.edited == "cycleTimes! measuredCycleTime! number! numbers! ");
  CHECK(times.read().cycles == 1);
  motion.cycle();
  CHECK(times.read().cycles == 2);
  CHECK(times.read().longestPeriod >= times.read().meanPeriod);
  CHECK(times.read().meanPeriod > 0);
}

} // namespace naocal
