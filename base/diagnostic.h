// What went wrong, where, why, and what to do next.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/source.h"

namespace durer {

enum class Severity : std::uint8_t { note, warning, error };

enum class Code : std::uint8_t {
#define DURER_CODE(name, code, meaning) name,
#include "base/codes.def"
#undef DURER_CODE
};

/// "D0214".
[[nodiscard]] std::string_view code_text(Code code);

/// A place that explains the main one: "in this block".
struct Label {
  Span span;
  std::string text;
};

/// How the place came to be read: "in macro `Varnish`, called here" (innermost first).
struct Frame {
  Span span;
  std::string text;
};

struct Diagnostic {
  Severity severity = Severity::error;
  Code code = Code::syntax;
  Span span;            // where; {0, 0} if it has no place in any file
  std::string message;  // lower case, no full stop, expected before found
  std::string at;       // optional words under the caret
  std::vector<Label> labels;
  std::vector<std::string> help;  // actions, with the text to type
  std::vector<Frame> trace;
};

/// Collects what libraries report; library boundaries do not throw.
class Diagnostics {
 public:
  explicit Diagnostics(const SourceMap& sources) : sources_(&sources) {}

  /// More errors than anybody reads at once.
  static constexpr std::size_t max_errors = 20;

  void report(Diagnostic d);
  [[nodiscard]] bool has_errors() const { return errors_ > 0; }
  /// All that were reported, kept or not.
  [[nodiscard]] std::size_t error_count() const { return errors_; }
  [[nodiscard]] const std::vector<Diagnostic>& all() const { return all_; }
  /// Errors that were not kept because there were enough already.
  [[nodiscard]] std::size_t dropped_errors() const {
    return errors_ > max_errors ? errors_ - max_errors : 0;
  }
  [[nodiscard]] const SourceMap& sources() const { return *sources_; }

 private:
  const SourceMap* sources_;
  std::vector<Diagnostic> all_;
  std::size_t errors_ = 0;
};

/// One diagnostic as text: claim, place, excerpt with caret, labels, help, notes; ends in a
/// newline.
[[nodiscard]] std::string render_diagnostic(const Diagnostic& d, const SourceMap& sources,
                                            bool colour = false);

}  // namespace durer
