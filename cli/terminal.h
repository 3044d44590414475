// The finished picture, drawn in a terminal.
#pragma once

#include <string>

#include "image/image.h"

namespace durer::cli {

enum class TerminalGraphics : std::uint8_t { half_blocks, kitty, sixel };

/// What a terminal says about itself.
struct Terminal {
  int columns = 80;
  TerminalGraphics graphics = TerminalGraphics::half_blocks;
};

/// The terminal behind file descriptor `fd`. Kitty's protocol is known by the environment; sixel by
/// the terminal's answer to a device attributes request, which is sent only if standard input and
/// `fd` are the same kind of real terminal and waits at most a fifth of a second.
[[nodiscard]] Terminal terminal_of(int fd);

/// Columns of the terminal behind `fd`; 0 if it is none.
[[nodiscard]] int terminal_columns(int fd);

/// True if the answer to a device attributes request ("\x1b[?62;4;22c") lists sixel graphics.
[[nodiscard]] bool answers_sixel(std::string_view answer);

/// The picture as text with escape sequences, at most `columns` wide, ending in a line break.
[[nodiscard]] std::string draw(const image::Image& image, const image::Encoding& encoding,
                               const Terminal& terminal);

/// Two pixels per character cell: "▀" with 24-bit colours.
[[nodiscard]] std::string half_blocks(const image::Image& image, const image::Encoding& encoding,
                                      int columns);
/// A PNG inside the kitty graphics protocol, in chunks of 4096 characters; no answer is asked for.
[[nodiscard]] std::string kitty(const image::Image& image, const image::Encoding& encoding,
                                int columns);
/// DEC sixel graphics with a fixed palette of 6·6·6 colours, dithered.
[[nodiscard]] std::string sixel(const image::Image& image, const image::Encoding& encoding,
                                int columns);

/// `image` with at most `columns` columns, its pixels averaged; never enlarged.
[[nodiscard]] image::Image shrunk(const image::Image& image, int columns);

}  // namespace durer::cli
