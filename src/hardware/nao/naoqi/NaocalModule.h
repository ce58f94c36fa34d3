#pragma once

#include "SharedBlock.h"

#include <alcommon/almodule.h>
#include <alproxies/almemoryproxy.h>
#include <alproxies/dcmproxy.h>
#include <alvalue/alvalue.h>
#include <boost/shared_ptr.hpp>
#include <string>
#include <vector>

namespace naocal {

/* NAOqi module; the DCM calls it before and after every exchange with the motor boards (10 ms). It never blocks. */
class NaocalModule : public AL::ALModule {
public:
  NaocalModule(boost::shared_ptr<AL::ALBroker> broker, const std::string& name);
  virtual ~NaocalModule();

  virtual void init();

private:
  void makeBlock();
  void measured();
  void command();
  void createAlias(const std::string& name, const std::vector<std::string>& keys);
  void set(const std::string& alias, const float* values, size_t count);

  AL::ALMemoryProxy memory_;
  AL::DCMProxy dcm_;
  shared::Block* block_;
  std::vector<const float*> sensors_;
  uint32_t commanded_; /* number of the last command sent to the DCM */
};

} // namespace naocal
