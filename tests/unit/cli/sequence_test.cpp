// The order of frames and commands, and what return letters do to it.
#include "cli/sequence.h"

#include "tests/unit/cli/read.h"

namespace durer::cli {
namespace {

struct Story {
  std::string text;  // commands and frames in their order
  int code = 0;
};

/// All six commands are there; `failing` fails.
Story story(std::vector<std::string> words, const std::string& failing = "", int render_code = 0) {
  for (const char* moment :
       {"Pre_Scene", "Pre_Frame", "Post_Frame", "Post_Scene", "User_Abort", "Fatal_Error"}) {
    words.push_back(std::string(moment) + "_Command=" + moment + "%n");
  }
  const Settings settings = test::accepted(words);
  Story s;
  SequenceActions actions;
  actions.render = [&](const FrameTask& task) {
    s.text += "(" + std::to_string(task.number) + ") ";
    return render_code;
  };
  actions.shell = [&](const std::string& command) {
    s.text += command + " ";
    return failing.empty() || !command.starts_with(failing) ? 0 : 1;
  };
  actions.names = [](const FrameTask& task) {
    ShellNames names;
    names.frame = task.number;
    return names;
  };
  s.code = run_sequence(settings, actions);
  return s;
}

}  // namespace

TEST_CASE("sequence: commands stand around the scene and around each frame", "[cli][sequence]") {
  const Story still = story({});
  CHECK(still.text == "Pre_Scene0 Pre_Frame0 (0) Post_Frame0 Post_Scene0 ");
  CHECK(still.code == 0);
  CHECK(story({"+KFI3", "+KFF4"}).text ==
        "Pre_Scene3 Pre_Frame3 (3) Post_Frame3 Pre_Frame4 (4) Post_Frame4 Post_Scene3 ");
}

TEST_CASE("sequence: a failure or an interruption ends it with its command", "[cli][sequence]") {
  const Story failed = story({"+KFF2"}, "", 1);
  CHECK(failed.text == "Pre_Scene1 Pre_Frame1 (1) Fatal_Error1 ");
  CHECK(failed.code == 1);
  const Story interrupted = story({"+KFF2"}, "", 2);
  CHECK(interrupted.text == "Pre_Scene1 Pre_Frame1 (1) User_Abort1 ");
  CHECK(interrupted.code == 2);
}

TEST_CASE("sequence: without a return letter failures are ignored", "[cli][sequence]") {
  CHECK(story({}, "P").code == 0);
  CHECK(story({"Pre_Frame_Return=I"}, "P").text == story({}).text);
}

TEST_CASE("sequence: skipping", "[cli][sequence]") {
  CHECK(story({"Pre_Scene_Return=S"}, "Pre_Scene").text == "Pre_Scene0 Post_Scene0 ");
  CHECK(story({"Pre_Scene_Return=A"}, "Pre_Scene").text == "Pre_Scene0 ");
  CHECK(story({"+KFF2", "Pre_Frame_Return=S"}, "Pre_Frame1").text ==
        "Pre_Scene1 Pre_Frame1 Pre_Frame2 (2) Post_Frame2 Post_Scene1 ");
  CHECK(story({"+KFF3", "Pre_Frame_Return=A"}, "Pre_Frame2").text ==
        "Pre_Scene1 Pre_Frame1 (1) Post_Frame1 Pre_Frame2 Post_Scene1 ");
  CHECK(story({"+KFF3", "Post_Frame_Return=A"}, "Post_Frame1").text ==
        "Pre_Scene1 Pre_Frame1 (1) Post_Frame1 Post_Scene1 ");
  CHECK(story({"+KFF1", "Post_Frame_Return=S"}, "Post_Frame").code == 0);
  CHECK(story({"Post_Scene_Return=A"}, "Post_Scene").code == 0);
}

TEST_CASE("sequence: quitting, interrupting and failing", "[cli][sequence]") {
  for (const char* moment : {"Pre_Scene", "Pre_Frame", "Post_Frame", "Post_Scene"}) {
    CAPTURE(moment);
    const auto with = [&](const char* letter) {
      return story({"+KFF2", std::string(moment) + "_Return=" + letter}, moment);
    };
    CHECK(with("Q").code == 0);
    CHECK(with("Q").text.find("Fatal") == std::string::npos);
    CHECK(with("U").code == 2);
    CHECK(with("U").text.find("User_Abort1") != std::string::npos);
    CHECK(with("F").code == 1);
    CHECK(with("F").text.find("Fatal_Error1") != std::string::npos);
  }
  CHECK(story({"Fatal_Error_Return=Q"}, "Fatal", 1).code == 0);
  CHECK(story({"User_Abort_Return=-F"}, "", 2).code == 1);
}

TEST_CASE("sequence: clocks of frames and of stills", "[cli][sequence]") {
  const FrameTask still = frame_task(test::accepted({"+K0.123456789"}), 0);
  CHECK(still.clock == Approx(0.123456791043).epsilon(1e-11));
  CHECK(still.clock_on);
  CHECK_FALSE(frame_task(test::accepted({}), 0).clock_on);
  const FrameTask second = frame_task(test::accepted({"+KFF3", "+K7"}), 1);
  CHECK(second.clock == 0.5);
  CHECK(second.clock_on);
  CHECK(second.number == 2);
  CHECK(second.count == 3);
}

}  // namespace durer::cli
