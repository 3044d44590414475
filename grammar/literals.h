// Long lists of literal numbers or vectors, as programs that export meshes write them. The grammar
// takes such a run of text as one item, checked but not converted; whoever wants the numbers reads
// them straight from the text. Megabytes of mesh so cost no syntax tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace durer::grammar {

/// Elements separated by commas, all numbers (`width` 1) or all vectors of `width` components.
struct LiteralRun {
  std::string_view text;  // from the first element to the last one, or the comma after it
  std::uint32_t count = 0;
  std::uint8_t width = 1;
  bool comma_after = false;  // the text ends with a comma
};

[[nodiscard]] inline bool may_begin_literal(char c) {
  return c == '<' || (c >= '0' && c <= '9') || c == '-' || c == '.';
}

/// The run that begins at `from`, blanks allowed between its marks, but no comments. Its last
/// element is followed by a comma, or by `}`. Count 0 if fewer than `shortest` elements; then
/// `stopped` says how far it looked.
[[nodiscard]] LiteralRun find_literals(const char* from, const char* end, std::uint32_t shortest,
                                       const char*& stopped);

/// The runs of a file: the first pass over its text finds them, the grammar looks them up.
class LiteralRuns {
 public:
  /// Fewer elements are not worth an item of their own.
  static constexpr std::uint32_t shortest = 16;

  /// Looks for a run at `at`, where a `{` or `,` precedes; null if there is none.
  const LiteralRun* find(const char* begin, const char* at, const char* end);
  /// The run found to begin there.
  [[nodiscard]] const LiteralRun* at(const char* at) const;

 private:
  std::vector<LiteralRun> runs_;  // in the order of the text
  const char* none_before_ = nullptr;
};

/// Reads the elements of a run one by one.
class LiteralReader {
 public:
  LiteralReader() = default;
  explicit LiteralReader(const LiteralRun& run) : LiteralReader(run, 0) {}
  /// From the element that begins at `offset` of the run's text.
  LiteralReader(const LiteralRun& run, std::size_t offset)
      : at_(run.text.data() + offset), end_(run.text.data() + run.text.size()), width_(run.width) {}

  /// The components of the next element into v[0]…v[width-1], correctly rounded. Goes on to the
  /// comma after it, or to the end.
  void read(double* v);
  /// Takes the comma after an element; false if there is none.
  bool comma();
  [[nodiscard]] std::size_t offset(const LiteralRun& run) const {
    return static_cast<std::size_t>(at_ - run.text.data());
  }

 private:
  const char* at_ = nullptr;
  const char* end_ = nullptr;
  int width_ = 1;
};

}  // namespace durer::grammar
