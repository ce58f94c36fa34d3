#include "framework/core/Database.hpp"

#include "framework/core/Module.hpp"
#include "framework/core/Thread.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace naocal {
namespace {

struct Origin {
  const AnyProduction* production;
  std::size_t thread, module;
};
using Origins = std::map<std::string, Origin>;

Origins originsOf(const std::vector<Thread*>& threads) {
  Origins origins;
  for (std::size_t t = 0; t < threads.size(); ++t) {
    for (std::size_t m = 0; m < threads[t]->modules().size(); ++m) {
      const Module& module = *threads[t]->modules()[m];
      for (const AnyProduction* production : module.productions()) {
        const std::string key = threads[t]->name() + "." + production->name();
        const auto [place, isNew] = origins.try_emplace(key, Origin{production, t, m});
        if (!isNew) {
          throw WiringError{fmt::format("{} is produced by two modules, {} and {}; a value has one producer: rename or "
                                        "remove one of them",
                                        key, threads[t]->modules()[place->second.module]->name(), module.name())};
        }
      }
    }
  }
  return origins;
}

/// The production of a dependency, after all checks of the pair.
const Origin& originOf(const AnyDependency& dependency, const Module& module, std::size_t thread,
                       const std::vector<Thread*>& threads, const Origins& origins) {
  const std::string own = threads[thread]->name() + "." + dependency.name();
  const bool elsewhere = !origins.contains(own) && dependency.name().find('.') != std::string::npos;
  const std::string key = elsewhere ? dependency.name() : own;
  const std::string who = threads[thread]->name() + "." + module.name();
  const auto found = origins.find(key);
  if (found == origins.end()) {
    throw WiringError{fmt::format("{} needs {}, which no module produces; add the module that does, or correct the "
                                  "name",
                                  who, key)};
  }
  const Origin& origin = found->second;
  if (origin.production->type() != dependency.type()) {
    throw WiringError{fmt::format("{} needs {} as a value of another type than {} produces; make the two types equal",
                                  who, key, threads[origin.thread]->modules()[origin.module]->name())};
  }
  if (origin.thread != thread && !origin.production->crossesThreads()) {
    throw WiringError{fmt::format("{} needs {}, which is computed by another thread while it is read; only a History "
                                  "or a Latest can be read by another thread",
                                  who, key)};
  }
  return origin;
}

/// For each module of a thread, the modules that must run before it.
using Predecessors = std::vector<std::set<std::size_t>>;

[[noreturn]] void refuseCircle(const Thread& thread, const Predecessors& predecessors,
                               const std::set<std::size_t>& left) {
  std::vector<std::size_t> path{*left.begin()}; // follows predecessors until a module repeats
  auto first = path.end();
  do {
    const auto& before = predecessors[path.back()];
    path.push_back(*std::find_if(before.begin(), before.end(), [&](std::size_t m) { return left.contains(m); }));
    first = std::find(path.begin(), path.end(), path.back());
  } while (first == path.end() - 1);
  path.erase(path.begin(), first);
  std::string names = thread.modules()[path.front()]->name();
  for (std::size_t i = 1; i < path.size(); ++i) {
    names += " needs " + thread.modules()[path[i]]->name() + (i + 1 < path.size() ? ", which" : "");
  }
  throw WiringError{
      fmt::format("{}: modules depend on each other in a circle: {}; none can be the first", thread.name(), names)};
}

std::vector<std::size_t> orderOf(const Thread& thread, const Predecessors& predecessors) {
  std::set<std::size_t> left;
  for (std::size_t i = 0; i < predecessors.size(); ++i) {
    left.insert(i);
  }
  std::vector<std::size_t> order;
  while (!left.empty()) {
    const auto ready = std::find_if(left.begin(), left.end(), [&](std::size_t candidate) {
      return std::none_of(predecessors[candidate].begin(), predecessors[candidate].end(),
                          [&](std::size_t before) { return left.contains(before); });
    });
    if (ready == left.end()) {
      refuseCircle(thread, predecessors, left);
    }
    order.push_back(*ready);
    left.erase(ready);
  }
  return order;
}

} // namespace

Database::Database(const std::vector<Thread*>& threads) {
  const Origins origins = originsOf(threads);
  std::map<const AnyProduction*, std::string> readers; // the first reader of each production
  std::vector<std::vector<std::size_t>> orders;        // applied last: `origins` holds the modules' old indices
  for (std::size_t t = 0; t < threads.size(); ++t) {
    Predecessors predecessors(threads[t]->modules().size());
    for (std::size_t m = 0; m < predecessors.size(); ++m) {
      const Module& module = *threads[t]->modules()[m];
      for (AnyDependency* dependency : module.dependencies()) {
        const Origin& origin = originOf(*dependency, module, t, threads, origins);
        dependency->connect(origin.production->value());
        if (origin.thread == t) {
          predecessors[m].insert(origin.module);
        }
        const std::string who = threads[t]->name() + "." + module.name();
        const auto [first, alone] = readers.try_emplace(origin.production, who);
        if (!alone && origin.production->mostReaders() == 1) {
          throw WiringError{fmt::format("{}.{} is a Latest, which one module takes from, and {} and {} both do; give "
                                        "each its own",
                                        threads[origin.thread]->name(), origin.production->name(), first->second, who)};
        }
      }
    }
    for (AnyProduction* production : threads[t]->productions()) {
      productions_[threads[t]->name() + "." + production->name()] = production;
    }
    orders.push_back(orderOf(*threads[t], predecessors));
  }
  for (std::size_t t = 0; t < threads.size(); ++t) {
    threads[t]->sort(orders[t]);
  }
}

AnyProduction* Database::find(std::string_view key) const {
  const auto entry = productions_.find(key);
  return entry == productions_.end() ? nullptr : entry->second;
}

} // namespace naocal
