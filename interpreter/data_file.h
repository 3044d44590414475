// Files that a scene reads and writes (language §4.11).
#pragma once

#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "interpreter/value.h"

namespace durer::interpreter {

/// One open file. Reading follows the oracle to the letter: after each value one more token is
/// taken, and lost unless it is a comma.
class DataFile {
 public:
  enum class Mode : std::uint8_t { read, write, append };

  /// Opens `path`; `good()` tells whether it worked.
  DataFile(const std::string& path, Mode mode);

  [[nodiscard]] bool good() const { return static_cast<bool>(stream_); }
  [[nodiscard]] Mode mode() const { return mode_; }
  [[nodiscard]] const std::string& path() const { return path_; }

  struct End {};
  struct Bad {
    std::string what;
  };
  using Datum = std::variant<End, Bad, Num, std::string>;
  /// The next value of a file opened for reading; strings are raw literals.
  Datum read();
  /// True once the end has been met: by a read, or by the look-ahead behind one.
  [[nodiscard]] bool at_end() const { return at_end_; }

  void write(std::string_view bytes) {
    stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }

 private:
  int skip_blank();
  std::optional<double> number(int first);

  std::string path_;
  Mode mode_;
  std::fstream stream_;
  bool at_end_ = false;
};

}  // namespace durer::interpreter
