#include "cli/create_ini.h"

#include "tests/unit/cli/read.h"

namespace durer::cli {

TEST_CASE("create ini: the file repeats the run", "[cli][ini]") {
  const test::Folder folder;
  const Settings first =
      test::accepted({"my scene.pov", "+W80", "+W90", "+A0.1", "+La", "+Lb", "Declare=X=1",
                      "Declare=S=\"x y\"", "+FN16", "+GIrun.ini"});
  REQUIRE_FALSE(create_ini(first));
  const Settings again = test::accepted({"run.ini"});
  CHECK(again.input == "my scene.pov");
  CHECK(again.width == 90);
  CHECK(again.antialias);
  CHECK(again.aa_threshold == 0.1);
  CHECK(again.library_paths == first.library_paths);
  CHECK(again.declares == first.declares);
  CHECK(again.bits == 16);
  CHECK(again.create_ini.empty());
}

TEST_CASE("create ini: an unwritable file is an error", "[cli][ini]") {
  CHECK(create_ini(test::accepted({"+GI/no/such/folder/x.ini"})));
  CHECK_FALSE(create_ini(test::accepted({})));
}

}  // namespace durer::cli
