#include "framework/core/Module.hpp"

namespace naocal {

AnyProduction::AnyProduction(Module& owner, std::string name, std::type_index type, bool crossesThreads,
                             int mostReaders)
    : name_{std::move(name)}, type_{type}, crossesThreads_{crossesThreads}, mostReaders_{mostReaders} {
  owner.productions_.push_back(this);
}

AnyDependency::AnyDependency(Module& owner, std::string name, std::type_index type)
    : name_{std::move(name)}, type_{type} {
  owner.dependencies_.push_back(this);
}

} // namespace naocal
