#pragma once

#include "protocol/Frames.hpp"

#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace naocal {

/// A robot's two UNIX sockets; sends only the given list of mounts, and records requests for keys and settings.
class FakeRobot {
public:
  FakeRobot(boost::asio::io_context& context, const std::filesystem::path& folder, std::string mounts)
      : mounts_{std::move(mounts)}, debug_{context, (folder / "debug").string()}, config_{
                                                                                      context,
                                                                                      (folder / "config").string()} {
    accept(debug_, debugFormat);
    accept(config_, configFormat);
  }

  std::vector<std::string> keysAskedFor; // mounts requested by GET_KEYS
  std::vector<std::string> settings;     // bodies of SET
  bool isSilent = false;                 // sends nothing at all

  /// Closes the connections to one of the two sockets.
  void closeDebug() { close(debugFormat); }
  void closeConfig() { close(configFormat); }

private:
  using Local = boost::asio::local::stream_protocol;
  struct Peer {
    Local::socket socket;
    const FrameFormat& format;
    std::string bytes;
  };

  void accept(Local::acceptor& acceptor, const FrameFormat& format) {
    acceptor.async_accept([this, &format, &acceptor](boost::system::error_code error, Local::socket socket) {
      if (!error) {
        peers_.push_back(std::make_shared<Peer>(Peer{std::move(socket), format, {}}));
        readHeader(peers_.back());
        accept(acceptor, format);
      }
    });
  }

  void readHeader(const std::shared_ptr<Peer>& peer) {
    peer->bytes.resize(peer->format.headerSize);
    boost::asio::async_read(peer->socket, boost::asio::buffer(peer->bytes),
                            [this, peer](boost::system::error_code error, std::size_t) {
                              if (!error) {
                                readBody(peer, parseHeader(peer->format, peer->bytes, 1 << 20));
                              }
                            });
  }

  void readBody(const std::shared_ptr<Peer>& peer, const FrameHeader& header) {
    peer->bytes.resize(header.bodySize);
    boost::asio::async_read(peer->socket, boost::asio::buffer(peer->bytes),
                            [this, peer, type = header.type](boost::system::error_code error, std::size_t) {
                              if (!error) {
                                answer(*peer, static_cast<ConfigType>(type));
                                readHeader(peer);
                              }
                            });
  }

  void close(const FrameFormat& format) {
    for (const std::shared_ptr<Peer>& peer : peers_) {
      if (&peer->format == &format) {
        boost::system::error_code ignored;
        peer->socket.close(ignored);
      }
    }
  }

  void answer(Peer& peer, ConfigType asked) {
    if (&peer.format != &configFormat) {
      return;
    }
    if (asked == ConfigType::getKeys) {
      keysAskedFor.push_back(peer.bytes);
    } else if (asked == ConfigType::set) {
      settings.push_back(peer.bytes);
    } else if (asked == ConfigType::getMounts && !isSilent) {
      boost::system::error_code ignored;
      boost::asio::write(peer.socket, boost::asio::buffer(encodeConfigFrame(ConfigType::sendMounts, mounts_)), ignored);
    }
  }

  std::string mounts_; // JSON
  std::vector<std::shared_ptr<Peer>> peers_;
  Local::acceptor debug_, config_;
};

} // namespace naocal
