#include "cli/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cli/animation.h"

namespace durer::cli {
namespace {

constexpr double megabyte = 1024 * 1024;

RunLimits trusted() { return {}; }

RunLimits untrusted() {
  RunLimits l;
  l.reading.macro_depth = 200;
  l.reading.include_depth = 20;
  l.reading.loop_turns = 10'000'000;
  l.reading.seconds = 30;
  l.reading.memory = static_cast<std::size_t>(4096 * megabyte);
  l.render_seconds = 600;
  l.pixels = 40e6;  // 8K video is 33 million
  l.frames = 10'000;
  return l;
}

template <typename To, typename From>
void take(To& to, const std::optional<From>& given, double unit = 1) {
  // A limit larger than any number of the type is none.
  if (given) to = static_cast<To>(std::min(static_cast<double>(*given) * unit, 9e15));
}

// An INI file may come with the scene, so it is not trusted either.
constexpr std::array command_line_only = {
    std::string_view("Output_File_Name"),   std::string_view("Create_Ini"),
    std::string_view("Library_Path"),       std::string_view("All_File"),
    std::string_view("Debug_File"),         std::string_view("Fatal_File"),
    std::string_view("Render_File"),        std::string_view("Statistic_File"),
    std::string_view("Warning_File"),       std::string_view("Radiosity_File_Name"),
    std::string_view("Radiosity_To_File"),  std::string_view("Radiosity_From_File"),
    std::string_view("Max_Macro_Depth"),    std::string_view("Max_Include_Depth"),
    std::string_view("Max_Loop_Turns"),     std::string_view("Max_Seconds"),
    std::string_view("Max_Render_Seconds"), std::string_view("Max_Memory"),
    std::string_view("Max_Pixels"),         std::string_view("Max_Frames"),
};

}  // namespace

RunLimits limits_of(const Settings& s) {
  RunLimits l = s.untrusted ? untrusted() : trusted();
  take(l.reading.macro_depth, s.max_macro_depth);
  take(l.reading.include_depth, s.max_include_depth);
  take(l.reading.loop_turns, s.max_loop_turns);
  take(l.reading.seconds, s.max_seconds);
  take(l.reading.memory, s.max_memory, megabyte);
  take(l.render_seconds, s.max_render_seconds);
  take(l.pixels, s.max_pixels);
  take(l.frames, s.max_frames);
  return l;
}

Problem check_untrusted(const Settings& s) {
  if (!s.untrusted) return {};
  for (const ShellHook& hook : s.hooks) {
    if (!hook.command.empty()) {
      return fmt::format("`{}`: an untrusted run has no shell commands", hook.command);
    }
  }
  for (const std::string_view keyword : command_line_only) {
    if (std::ranges::find(s.from_ini, keyword) == s.from_ini.end()) continue;
    return fmt::format(
        "{} stands in an INI file: in an untrusted run only the command line may "
        "give it",
        keyword);
  }
  return {};
}

Problem check_extent(const Settings& s) {
  const RunLimits l = limits_of(s);
  const double pixels = static_cast<double>(s.width) * s.height;
  if (l.pixels > 0 && pixels > l.pixels) {
    return fmt::format("{}x{} are {:.0f} pixels, more than Max_Pixels={:.0f}", s.width, s.height,
                       pixels, l.pixels);
  }
  const auto animation = animation_of(s);
  if (l.frames > 0 && animation && animation->count() > l.frames) {
    return fmt::format("there are {} frames, more than Max_Frames={}", animation->count(),
                       l.frames);
  }
  return {};
}

}  // namespace durer::cli
