#include "commands/explore/LineEditor.hpp"

#include "console/print/PrintText.hpp"

#include <algorithm>
#include <clocale>
#include <cstdio>
#include <fmt/ranges.h>
#include <histedit.h>
#include <iostream>
#include <sstream>
#include <unistd.h>

namespace naocal {

/// libedit's state. Its callbacks find it as their client data.
struct LineEditor::Terminal {
  Terminal(std::string itsPrompt, Choices itsChoices)
      : prompt{std::move(itsPrompt)}, choices{std::move(itsChoices)},
        editor{::el_init("naocal", stdin, stdout, stderr)}, history{::history_init()} {
    HistEvent event;
    ::history(history, &event, H_SETSIZE, 500);
    ::el_set(editor, EL_CLIENTDATA, this);
    ::el_set(editor, EL_PROMPT, promptOf);
    ::el_set(editor, EL_EDITOR, "emacs");
    ::el_set(editor, EL_SIGNAL, 1);
    ::el_set(editor, EL_HIST, ::history, history);
    ::el_set(editor, EL_ADDFN, "naocal-complete", "completes the word", completeWord);
    ::el_set(editor, EL_BIND, "^I", "naocal-complete", nullptr);
    ::el_source(editor, nullptr);
  }
  ~Terminal() {
    ::history_end(history);
    ::el_end(editor);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  static Terminal& of(EditLine* editor) {
    void* terminal = nullptr;
    ::el_get(editor, EL_CLIENTDATA, &terminal);
    return *static_cast<Terminal*>(terminal);
  }
  static char* promptOf(EditLine* editor) { return of(editor).prompt.data(); }
  static unsigned char completeWord(EditLine* editor, int key);

  std::string prompt;
  Choices choices;
  EditLine* editor;
  History* history;
};

unsigned char LineEditor::Terminal::completeWord(EditLine* editor, int) {
  const LineInfo* line = ::el_line(editor);
  std::istringstream typed{std::string{line->buffer, line->cursor}};
  std::vector<std::string> words;
  for (std::string word; typed >> word;) {
    words.push_back(word);
  }
  if (line->cursor == line->buffer || line->cursor[-1] == ' ') {
    words.emplace_back();
  }
  const Completion completion = complete(words.back(), of(editor).choices(words));
  if (!completion.inserted.empty()) {
    return ::el_insertstr(editor, completion.inserted.c_str()) == 0 ? CC_REFRESH : CC_ERROR;
  }
  if (completion.choices.empty()) {
    return CC_ERROR;
  }
  printText("\n{}\n", fmt::join(completion.choices, "  "));
  std::fflush(stdout);
  return CC_REDISPLAY;
}

LineEditor::LineEditor(std::string prompt, Choices choices) : prompt_{std::move(prompt)} {
  if (::isatty(STDIN_FILENO) != 0 && ::isatty(STDOUT_FILENO) != 0) {
    std::setlocale(LC_CTYPE, ""); // letters of more than one byte
    terminal_ = std::make_unique<Terminal>(prompt_, std::move(choices));
  }
}

LineEditor::~LineEditor() = default;

std::optional<std::string> LineEditor::read() {
  std::string line;
  if (!terminal_) {
    printText("{}", prompt_);
    std::fflush(stdout);
    return std::getline(std::cin, line) ? std::optional{line} : std::nullopt;
  }
  int length = 0;
  const char* typed = ::el_gets(terminal_->editor, &length);
  if (typed == nullptr || length <= 0) {
    return std::nullopt;
  }
  line.assign(typed, static_cast<std::size_t>(length));
  line.erase(std::find(line.begin(), line.end(), '\n'), line.end());
  if (line.find_first_not_of(' ') != std::string::npos) {
    HistEvent event;
    ::history(terminal_->history, &event, H_ENTER, line.c_str());
  }
  return line;
}

Completion complete(const std::string& word, const std::vector<std::string>& choices) {
  std::vector<std::string> fitting;
  std::copy_if(choices.begin(), choices.end(), std::back_inserter(fitting),
               [&](const std::string& choice) { return choice.starts_with(word); });
  if (fitting.empty()) {
    return {};
  }
  std::string common = fitting.front();
  for (const std::string& choice : fitting) {
    const auto end = std::mismatch(common.begin(), common.end(), choice.begin(), choice.end()).first;
    common.erase(end, common.end());
  }
  Completion completion{.inserted = common.substr(word.size()), .choices = {}};
  if (fitting.size() == 1) {
    completion.inserted += ' ';
  } else if (completion.inserted.empty()) {
    completion.choices = std::move(fitting);
  }
  return completion;
}

} // namespace naocal
