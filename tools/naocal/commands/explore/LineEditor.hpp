#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Reads a user's lines: on a terminal with editing keys, the earlier lines (up, down) and completion (Tab), with
/// libedit and the user's .editrc; elsewhere as they come.
class LineEditor {
public:
  /// All words that may stand where the last one of `words` is being typed; `words` has at least one, maybe empty.
  using Choices = std::function<std::vector<std::string>(const std::vector<std::string>& words)>;

  LineEditor(std::string prompt, Choices choices);
  ~LineEditor();

  /// The next line, without its end; absent at the end of the input.
  std::optional<std::string> read();

private:
  struct Terminal;
  std::string prompt_;
  std::unique_ptr<Terminal> terminal_; // absent: the input is no terminal
};

/// What completion does with the word that is being typed.
struct Completion {
  std::string inserted; // text that all choices have in common beyond the word, and a space after the only one
  std::vector<std::string> choices; // to list: more than one, and nothing in common to insert
};
Completion complete(const std::string& word, const std::vector<std::string>& choices);

} // namespace naocal
