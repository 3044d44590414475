// What the terminal can do.
#include "cli/terminal.h"

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace durer::cli {
namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// Multiplexers do not pass the protocol on, though the variables of the outer terminal survive.
bool speaks_kitty() {
  if (!environment("TMUX").empty() || environment("TERM").starts_with("screen")) return false;
  return !environment("KITTY_WINDOW_ID").empty() || environment("TERM") == "xterm-kitty" ||
         environment("TERM") == "xterm-ghostty" || environment("TERM_PROGRAM") == "ghostty";
}

/// Sends `request` and collects what comes back until `last`, without echo.
std::string ask(int fd, std::string_view request, char last) {
  termios before{};
  if (::tcgetattr(STDIN_FILENO, &before) != 0) return {};
  termios raw = before;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  raw.c_cc[VMIN] = 0;
  raw.c_cc[VTIME] = 0;
  ::tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  std::string answer;
  if (::write(fd, request.data(), request.size()) == static_cast<ssize_t>(request.size())) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    char c = 0;
    while (answer.size() < 64 && ::poll(&input, 1, 200) > 0 && ::read(STDIN_FILENO, &c, 1) == 1) {
      answer += c;
      if (c == last) break;
    }
  }
  ::tcsetattr(STDIN_FILENO, TCSANOW, &before);
  return answer;
}

}  // namespace

int terminal_columns(int fd) {
  if (::isatty(fd) == 0) return 0;
  winsize size{};
  if (::ioctl(fd, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

bool answers_sixel(std::string_view answer) {
  const std::size_t start = answer.find("\x1b[?");
  if (start == std::string_view::npos || !answer.ends_with('c')) return false;
  std::string list = ";";
  list += answer.substr(start + 3, answer.size() - start - 4);
  list += ';';
  return list.find(";4;") != std::string::npos;
}

Terminal terminal_of(int fd) {
  const int columns = terminal_columns(fd);
  if (columns == 0) return {};
  if (speaks_kitty()) return {columns, TerminalGraphics::kitty};
  const bool can_ask = ::isatty(STDIN_FILENO) != 0 && environment("TERM") != "dumb";
  if (can_ask && answers_sixel(ask(fd, "\x1b[c", 'c'))) return {columns, TerminalGraphics::sixel};
  return {columns, TerminalGraphics::half_blocks};
}

}  // namespace durer::cli
