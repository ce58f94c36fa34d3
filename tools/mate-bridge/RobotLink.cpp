#include "RobotLink.hpp"

#include "RobotConversation.hpp"

namespace naocal {

RobotLink::RobotLink(boost::asio::io_context& context, const std::string& address, RobotCalls calls)
    : conversation_{std::make_shared<RobotConversation>(context, address, std::move(calls))} {
  conversation_->connect();
}

RobotLink::~RobotLink() {
  conversation_->drop();
}

bool RobotLink::connected() const {
  return conversation_->connected();
}

const std::string& RobotLink::sentence() const {
  return conversation_->sentence();
}

void RobotLink::subscribe(const std::string& key) {
  conversation_->subscribe(key);
}

void RobotLink::unsubscribe(const std::string& key) {
  conversation_->unsubscribe(key);
}

void RobotLink::askForKeys(const std::string& mount) {
  conversation_->say(ConfigFrame::getKeys, mount);
}

bool RobotLink::set(const std::string& settings) {
  return conversation_->say(ConfigFrame::set, settings);
}

bool RobotLink::introduce(const std::string& settings) {
  return conversation_->introduce(settings);
}

void RobotLink::rest() {
  conversation_->rest();
}

void RobotLink::wake() {
  conversation_->wake();
}

bool RobotLink::save() {
  return conversation_->say(ConfigFrame::save);
}

} // namespace naocal
