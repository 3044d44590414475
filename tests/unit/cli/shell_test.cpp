#include "cli/shell.h"

#include "tests/unit/cli/read.h"

namespace durer::cli {

TEST_CASE("shell: letters behind a percent sign are replaced", "[cli][shell]") {
  const ShellNames names{"dir/a07.png", "a", 7, 0.25, 320, 200};
  CHECK(substitute("x %o %s %n %k %w %h %% %z %", names) ==
        "x dir/a07.png a 7 0.25 320 200 % %z %");
}

TEST_CASE("shell: return letters, and their reverse", "[cli][shell]") {
  const auto hook = [](const std::string& value) {
    return test::accepted({"Pre_Frame_Return=" + value})
        .hooks[static_cast<std::size_t>(Moment::pre_frame)];
  };
  const Action actions[] = {Action::ignore, Action::skip,       Action::skip_all,
                            Action::quit,   Action::user_abort, Action::fatal};
  for (int i = 0; i < 6; ++i) {
    const std::string letter(1, "ISAQUF"[i]);
    CHECK(action_after(hook(letter), 3) == actions[i]);
    CHECK(action_after(hook(letter), 0) == Action::ignore);
    CHECK(action_after(hook("-" + letter), 0) == actions[i]);
    CHECK(action_after(hook("!" + letter), 3) == Action::ignore);
  }
  CHECK(action_after(hook("fatal"), 1) == Action::fatal);
  for (const char* bad : {"X", "", "-", "3"}) {
    test::refused({std::string("Post_Scene_Return=") + bad});
  }
}

TEST_CASE("shell: exit codes come back", "[cli][shell]") {
  CHECK(run_shell("exit 0") == 0);
  CHECK(run_shell("exit 3") == 3);
}

}  // namespace durer::cli
