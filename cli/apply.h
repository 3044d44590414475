// What the lines of the option table do with their values. Only options.cpp includes this.
#pragma once

#include <fmt/format.h>

#include <algorithm>

#include "cli/options.h"
#include "cli/values.h"

namespace durer::cli::apply {

inline Problem expected(std::string_view what, std::string_view value) {
  return fmt::format("expected {}, found `{}`", what, value);
}

/// A letter of I S A Q U F, perhaps behind `-` or `!`.
Problem return_action(ShellHook& hook, std::string_view value);

template <auto Member>
Problem boolean(Settings& s, std::string_view value) {
  const auto b = parse_bool(value);
  if (!b) return expected("on or off", value);
  s.*Member = *b;
  return {};
}

/// A whole number from Low to High; others are an error.
template <auto Member, int Low, int High>
Problem whole(Settings& s, std::string_view value) {
  const auto n = parse_int(value);
  if (!n || *n < Low || *n > High) {
    return expected(fmt::format("a whole number from {} to {}", Low, High), value);
  }
  s.*Member = *n;
  return {};
}

/// A whole number; what lies outside Low…High is moved to the nearer end, as POV-Ray does.
template <auto Member, int Low, int High>
Problem clamped_whole(Settings& s, std::string_view value) {
  const auto n = parse_int(value);
  if (!n) return expected("a whole number", value);
  s.*Member = std::clamp(*n, Low, High);
  return {};
}

/// A number greater than 0.
template <auto Member>
Problem positive(Settings& s, std::string_view value) {
  const auto x = parse_number(value);
  if (!x || *x <= 0) return expected("a number greater than 0", value);
  s.*Member = *x;
  return {};
}

template <auto Member>
Problem number(Settings& s, std::string_view value) {
  const auto x = parse_number(value);
  if (!x) return expected("a number", value);
  s.*Member = *x;
  return {};
}

/// A number, moved into 0…1.
template <auto Member>
Problem fraction(Settings& s, std::string_view value) {
  const auto x = parse_number(value);
  if (!x) return expected("a number from 0 to 1", value);
  s.*Member = std::clamp(*x, 0.0, 1.0);
  return {};
}

template <auto Member>
Problem text(Settings& s, std::string_view value) {
  s.*Member = std::string(value);
  return {};
}

/// A pixel or frame number, or a fraction.
template <auto Member>
Problem place(Settings& s, std::string_view value) {
  const auto x = parse_number(value);
  if (!x || *x < 0) return expected("a number from 1 or a fraction from 0 to 1", value);
  s.*Member = *x;
  return {};
}

template <Moment M>
Problem shell_command(Settings& s, std::string_view value) {
  s.hooks[static_cast<std::size_t>(M)].command = value;
  return {};
}

template <Moment M>
Problem shell_return(Settings& s, std::string_view value) {
  return return_action(s.hooks[static_cast<std::size_t>(M)], value);
}

template <Stream S>
Problem console(Settings& s, std::string_view value) {
  const auto b = parse_bool(value);
  if (!b) return expected("on or off", value);
  s.streams[static_cast<std::size_t>(S)].console = *b;
  return {};
}

template <Stream S>
Problem stream_file(Settings& s, std::string_view value) {
  s.streams[static_cast<std::size_t>(S)].file = value;
  return {};
}

/// Values that change nothing are still read: a slip of the pen is an error in every option.
Problem ignored_boolean(Settings& s, std::string_view value);
Problem ignored_number(Settings& s, std::string_view value);
Problem ignored_text(Settings& s, std::string_view value);
/// For what is not there yet: only `off` is accepted, or an empty text.
Problem only_off(Settings& s, std::string_view value);
Problem only_empty(Settings& s, std::string_view value);

Problem input(Settings& s, std::string_view value);
Problem output_type(Settings& s, std::string_view value);
Problem dither_method(Settings& s, std::string_view value);
Problem file_gamma(Settings& s, std::string_view value);
Problem integrator(Settings& s, std::string_view value);
Problem size(Settings& s, std::string_view value);
Problem library_path(Settings& s, std::string_view value);
Problem declare(Settings& s, std::string_view value);
Problem clock(Settings& s, std::string_view value);
Problem version(Settings& s, std::string_view value);
Problem aa_gamma(Settings& s, std::string_view value);
Problem all_console(Settings& s, std::string_view value);
Problem diagnostics_format(Settings& s, std::string_view value);
Problem dump_scene(Settings& s, std::string_view value);
Problem untrusted(Settings& s, std::string_view value);

}  // namespace durer::cli::apply
