#include "RobotClient.hpp"

#include "RobotConversation.hpp"

namespace naocal {

RobotClient::RobotClient(boost::asio::io_context& context, const std::string& address, RobotCalls calls)
    : conversation_{std::make_shared<RobotConversation>(context, address, std::move(calls))} {
  conversation_->connect();
}

RobotClient::~RobotClient() {
  conversation_->drop();
}

bool RobotClient::connected() const {
  return conversation_->connected();
}

const std::string& RobotClient::sentence() const {
  return conversation_->sentence();
}

void RobotClient::subscribe(const std::string& key) {
  conversation_->subscribe(key);
}

void RobotClient::unsubscribe(const std::string& key) {
  conversation_->unsubscribe(key);
}

void RobotClient::askForKeys(const std::string& mount) {
  conversation_->say(ConfigFrame::getKeys, mount);
}

bool RobotClient::set(const std::string& settings) {
  return conversation_->say(ConfigFrame::set, settings);
}

bool RobotClient::introduce(const std::string& settings) {
  return conversation_->introduce(settings);
}

void RobotClient::rest() {
  conversation_->rest();
}

void RobotClient::wake() {
  conversation_->wake();
}

bool RobotClient::save() {
  return conversation_->say(ConfigFrame::save);
}

} // namespace naocal
