#include "recordings/mcap/McapReader.hpp"

#include "io/InputError.hpp"
#include "recordings/mcap/McapChunk.hpp"

#include <array>
#include <cstring>
#include <fmt/format.h>
#include <istream>
#include <limits>
#include <map>
#include <type_traits>

namespace naocal {

namespace {

constexpr std::string_view magic{"\x89MCAP0\r\n", 8};

enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  dataEnd = 0x0F,
};

struct Channel {
  std::string topic, schema, encoding;
};

/// The fields of a record, in their order.
class RecordFields {
public:
  RecordFields(std::string_view content, std::string where) : rest_{content}, where_{std::move(where)} {}

  template <typename T> T number() {
    const std::string_view bytes = take(sizeof(T));
    T result;
    std::memcpy(&result, bytes.data(), sizeof(T)); // little-endian, as all machines that naocal supports
    return result;
  }
  std::string_view text() { return take(number<std::uint32_t>()); }
  std::string_view take(std::uint64_t size) {
    if (size > rest_.size()) {
      throw InputError{fmt::format("{}: expected {} more bytes in this record, found {}", where_, size, rest_.size())};
    }
    const std::string_view result = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return result;
  }
  std::string_view rest() const { return rest_; }
  const std::string& where() const { return where_; }

private:
  std::string_view rest_;
  std::string where_;
};

class McapWalk {
public:
  McapWalk(std::istream& file, const std::string& name, const std::function<bool(const McapMessage&)>& visit)
      : file_{file}, name_{name}, visit_{visit} {}

  void run() {
    std::array<char, magic.size()> start{};
    file_.read(start.data(), start.size());
    if (std::string_view{start.data(), static_cast<std::size_t>(file_.gcount())} != magic) {
      throw InputError{fmt::format("{}: expected an MCAP recording, found another format; ROS 1 bags and ROS 2's "
                                   "sqlite3 bags must be converted first (mcap convert)",
                                   name_)};
    }
    byte_ = magic.size();
    while (!ended_) {
      readRecord();
    }
  }

private:
  std::string where() const { return fmt::format("{}, byte {}", name_, byte_); }

  [[noreturn]] void refuseEnd() const {
    throw InputError{fmt::format("{}: expected another record, found the end of the file: the recording was cut off; "
                                 "repair it first (mcap recover)",
                                 where())};
  }

  void readRecord() {
    std::array<char, 9> head{}; // opcode, length
    file_.read(head.data(), head.size());
    if (static_cast<std::size_t>(file_.gcount()) != head.size()) {
      refuseEnd();
    }
    std::uint64_t length = 0;
    std::memcpy(&length, head.data() + 1, sizeof(length));
    const auto opcode = static_cast<Opcode>(head[0]);
    switch (opcode) {
    case Opcode::schema:
    case Opcode::channel:
    case Opcode::message:
    case Opcode::chunk:
      visitContent(opcode, readContent(length));
      break;
    case Opcode::dataEnd:
    case Opcode::footer:
      ended_ = true;
      break;
    default: // index, attachments and later kinds
      skip(length);
    }
    byte_ += head.size() + length;
  }

  std::string readContent(std::uint64_t length) {
    if (length > largestMcapRecord) {
      throw InputError{fmt::format("{}: expected a record of at most {} MiB, found {} bytes", where(),
                                   largestMcapRecord >> 20, length)};
    }
    std::string content;
    constexpr std::uint64_t piece = 1 << 20; // a false length fails before its memory is taken
    while (content.size() < length) {
      const std::size_t had = content.size(), more = std::min(piece, length - had);
      content.resize(had + more);
      file_.read(content.data() + had, static_cast<std::streamsize>(more));
      if (static_cast<std::size_t>(file_.gcount()) != more) {
        refuseEnd();
      }
    }
    return content;
  }

  void skip(std::uint64_t length) {
    constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::streamsize>::max());
    if (length > 0 && (length > most || !file_.ignore(static_cast<std::streamsize>(length)) ||
                       static_cast<std::uint64_t>(file_.gcount()) != length)) {
      refuseEnd();
    }
  }

  void visitContent(Opcode opcode, std::string_view content) {
    RecordFields fields{content, where()};
    switch (opcode) {
    case Opcode::schema:
      readSchema(fields);
      break;
    case Opcode::channel:
      readChannel(fields);
      break;
    case Opcode::message:
      readMessage(fields);
      break;
    case Opcode::chunk:
      readChunk(fields);
      break;
    default:
      break;
    }
  }

  void readSchema(RecordFields& fields) {
    const auto id = fields.number<std::uint16_t>();
    schemas_[id] = fields.text();
  }

  void readChannel(RecordFields& fields) {
    const auto id = fields.number<std::uint16_t>(), schema = fields.number<std::uint16_t>();
    Channel& channel = channels_[id];
    channel.topic = fields.text();
    channel.encoding = fields.text();
    if (schema != 0 && !schemas_.contains(schema)) {
      throw InputError{fmt::format("{}: expected the schema {} before its channel \"{}\", found none", fields.where(),
                                   schema, printableText(channel.topic, 80))};
    }
    channel.schema = schema == 0 ? "" : schemas_.at(schema);
  }

  void readMessage(RecordFields& fields) {
    const auto id = fields.number<std::uint16_t>();
    fields.take(sizeof(std::uint32_t)); // sequence
    const auto time = fields.number<std::uint64_t>();
    fields.take(sizeof(std::uint64_t)); // publish time
    const auto channel = channels_.find(id);
    if (channel == channels_.end()) {
      throw InputError{fmt::format("{}: expected the channel {} before its message, found none", fields.where(), id)};
    }
    const Channel& of = channel->second;
    ended_ = !visit_(
        {of.topic, of.schema, of.encoding, std::chrono::nanoseconds{static_cast<std::int64_t>(time)}, fields.rest()});
  }

  void readChunk(RecordFields& fields) {
    fields.take(2 * sizeof(std::uint64_t)); // first and last time
    const auto size = fields.number<std::uint64_t>();
    const auto checksum = fields.number<std::uint32_t>();
    const std::string_view compression = fields.text();
    const std::string_view compressed = fields.take(fields.number<std::uint64_t>());
    if (size > largestMcapRecord) {
      throw InputError{fmt::format("{}: expected a chunk of at most {} MiB, found {} bytes", fields.where(),
                                   largestMcapRecord >> 20, size)};
    }
    const std::string records = decompressMcapChunk(compression, compressed, size, fields.where());
    if (checksum != 0 && checksum != crc32Of(records)) { // 0: none
      throw InputError{fmt::format("{}: expected a chunk with the checksum {:08x}, found {:08x}: the file is damaged",
                                   fields.where(), checksum, crc32Of(records))};
    }
    RecordFields inside{records, fields.where() + " (chunk)"};
    while (!inside.rest().empty() && !ended_) {
      const auto opcode = static_cast<Opcode>(inside.number<std::uint8_t>());
      const std::string_view content = inside.take(inside.number<std::uint64_t>());
      if (opcode != Opcode::chunk) { // chunks do not nest
        visitContent(opcode, content);
      }
    }
  }

  std::istream& file_;
  const std::string& name_;
  const std::function<bool(const McapMessage&)>& visit_;
  std::uint64_t byte_ = 0; // of the current record
  bool ended_ = false;
  std::map<std::uint16_t, std::string> schemas_; // name by id
  std::map<std::uint16_t, Channel> channels_;
};

} // namespace

void visitMcapMessages(std::istream& file, const std::string& name,
                       const std::function<bool(const McapMessage&)>& visit) {
  McapWalk{file, name, visit}.run();
}

} // namespace naocal
