#include "NaocalModule.h"

#include "DeviceKeys.h"

#include <alcommon/albroker.h>
#include <alcommon/albrokermanager.h>
#include <alcommon/alproxy.h>
#include <boost/bind.hpp>
#include <fcntl.h>
#include <stdexcept>
#include <string.h>
#include <sys/mman.h>

namespace naocal {
namespace {

/* Removes the right hip yaw-pitch, which has no motor of its own. */
void withoutRightHip(const float* all, float* commanded) {
  for (size_t joint = 0, next = 0; joint < shared::jointCount; ++joint) {
    if (joint != rightHipYawPitch) {
      commanded[next++] = all[joint];
    }
  }
}

} // namespace

NaocalModule::NaocalModule(boost::shared_ptr<AL::ALBroker> broker, const std::string& name)
    : AL::ALModule(broker, name), memory_(broker), dcm_(broker), block_(0), commanded_(0) {
  setModuleDescription("Exchanges joints, sensors and lights with naocal through shared memory.");
}

NaocalModule::~NaocalModule() {
  if (block_) {
    munmap(block_, sizeof(shared::Block));
  }
}

void NaocalModule::init() {
  const Keys keys = sensorKeys();
  for (size_t i = 0; i < keys.size(); ++i) {
    sensors_.push_back(static_cast<const float*>(memory_.getDataPtr(keys[i])));
  }
  createAlias("naocalAngles", jointKeys("/Position/Actuator/Value", true));
  createAlias("naocalStiffness", jointKeys("/Hardness/Actuator/Value", true));
  createAlias("naocalLights", lightKeys());
  makeBlock();
  boost::shared_ptr<AL::ALProxy> dcm = getParentBroker()->getProxy("DCM");
  dcm->getModule()->atPreProcess(boost::bind(&NaocalModule::command, this));
  dcm->getModule()->atPostProcess(boost::bind(&NaocalModule::measured, this));
}

/* Reuses the block of an earlier NAOqi, which naocal may have mapped. Writes the magic number last. */
void NaocalModule::makeBlock() {
  const int file = shm_open(shared::blockName, O_RDWR | O_CREAT, 0600);
  void* memory = MAP_FAILED;
  if (file >= 0 && ftruncate(file, sizeof(shared::Block)) == 0) {
    memory = mmap(0, sizeof(shared::Block), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  }
  if (file >= 0) {
    close(file);
  }
  if (memory == MAP_FAILED) {
    throw std::runtime_error("naocal: the shared memory could not be made");
  }
  block_ = static_cast<shared::Block*>(memory);
  block_->version = shared::blockVersion;
  block_->size = sizeof(shared::Block);
  const std::string body = memory_.getData("Device/DeviceList/ChestBoard/BodyId"),
                    head = memory_.getData("RobotConfig/Head/FullHeadId");
  strncpy(block_->bodyId, body.c_str(), shared::idLength - 1);
  strncpy(block_->headId, head.c_str(), shared::idLength - 1);
  strncpy(block_->bodyVersion, "V5.0", shared::idLength - 1);
  strncpy(block_->headVersion, "V5.0", shared::idLength - 1);
  commanded_ = __atomic_load_n(&block_->commandCount, __ATOMIC_ACQUIRE);
  __atomic_store_n(&block_->magic, shared::blockMagic, __ATOMIC_RELEASE);
}

void NaocalModule::measured() {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  shared::State state;
  state.secondsLow = uint32_t(now.tv_sec);
  state.secondsHigh = uint32_t(uint64_t(now.tv_sec) >> 32);
  state.nanoseconds = uint32_t(now.tv_nsec);
  float* values = state.angles; /* and the following members */
  for (size_t i = 0; i < sensors_.size(); ++i) {
    values[i] = *sensors_[i];
  }
  shared::publish(block_->states, block_->stateCount, state);
  shared::wake(block_->stateCount);
}

/* Sends nothing without a new command: motors keep their last target. */
void NaocalModule::command() {
  shared::Command command;
  const uint32_t number = shared::newest(block_->commands, block_->commandCount, command);
  if (number == 0 || number == commanded_) {
    return;
  }
  commanded_ = number;
  float values[shared::jointCount - 1];
  withoutRightHip(command.angles, values);
  set("naocalAngles", values, shared::jointCount - 1);
  withoutRightHip(command.stiffness, values);
  set("naocalStiffness", values, shared::jointCount - 1);
  set("naocalLights", command.chest, (sizeof command - offsetof(shared::Command, chest)) / sizeof(float));
}

void NaocalModule::createAlias(const std::string& name, const std::vector<std::string>& keys) {
  AL::ALValue alias;
  alias.arraySetSize(2);
  alias[0] = name;
  alias[1].arraySetSize(int(keys.size()));
  for (size_t i = 0; i < keys.size(); ++i) {
    alias[1][int(i)] = keys[i];
  }
  dcm_.createAlias(alias);
}

void NaocalModule::set(const std::string& alias, const float* values, size_t count) {
  AL::ALValue commands;
  commands.arraySetSize(6);
  commands[0] = alias;
  commands[1] = std::string("ClearAll");
  commands[2] = std::string("time-separate");
  commands[3] = 0;
  commands[4].arraySetSize(1);
  commands[4][0] = dcm_.getTime(0);
  commands[5].arraySetSize(int(count));
  for (size_t i = 0; i < count; ++i) {
    commands[5][int(i)].arraySetSize(1);
    commands[5][int(i)][0] = values[i];
  }
  dcm_.setAlias(commands);
}

} // namespace naocal

extern "C" int _createModule(boost::shared_ptr<AL::ALBroker> broker) {
  AL::ALBrokerManager::setInstance(broker->fBrokerManager.lock());
  AL::ALBrokerManager::getInstance()->addBroker(broker);
  AL::ALModule::createModule<naocal::NaocalModule>(broker, "naocal");
  return 0;
}

extern "C" int _closeModule() {
  return 0;
}
