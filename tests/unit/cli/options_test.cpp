// Every row of the table of language §9.2: value, sign and case.
#include "cli/options.h"

#include <cstring>
#include <map>
#include <set>

#include "cli/values.h"
#include "tests/unit/cli/read.h"

namespace durer::cli {
namespace {

using test::accepted;
using test::refused;

/// A legal value for each option, as far as `1` and `on` do not serve.
std::string sample(const Option& o) {
  static const std::map<std::string_view, std::string> special = {
      {"Output_File_Type", "N"}, {"Size", "8x6"},  {"Declare", "A=1"},    {"Bits_Per_Color", "8"},
      {"Version", "3.7"},        {"Quality", "9"}, {"File_Gamma", "1.8"}, {"Diagnostics", "json"},
      {"Dither_Method", "B4"},    {"Integrator", "path"},
  };
  if (o.keyword.ends_with("_Return")) return "S";
  if (const auto found = special.find(o.keyword); found != special.end()) return found->second;
  const bool off = o.group == Group::not_yet;
  if (o.form == Form::flag || o.form == Form::type) return off ? "off" : "on";
  return off ? "" : "1";
}

}  // namespace

TEST_CASE("options: keywords, switches and GNU names are unique", "[cli][options]") {
  std::set<std::string> keywords;
  std::set<std::string_view> letters;
  std::set<std::string_view> names;
  for (const Option& o : options()) {
    CAPTURE(o.keyword);
    CHECK(keywords.insert(lower(o.keyword)).second);
    if (!o.letters.empty()) CHECK(letters.insert(o.letters).second);
    if (!o.long_name.empty()) CHECK(names.insert(o.long_name).second);
    if (!o.companion.empty()) CHECK(option_of_keyword(o.companion) != nullptr);
  }
}

TEST_CASE("options: every switch and keyword of the language is known", "[cli][options]") {
  // The table of language §9.2: switch=keyword.
  for (const char* row : {"I=Input_File_Name",
                          "O=Output_File_Name",
                          "W=Width",
                          "H=Height",
                          "A=Antialias",
                          "AM=Sampling_Method",
                          "R=Antialias_Depth",
                          "J=Jitter",
                          "AG=Antialias_Gamma",
                          "Q=Quality",
                          "D=Display",
                          "P=Pause_When_Done",
                          "F=Output_To_File",
                          "=Output_File_Type",
                          "=Bits_Per_Color",
                          "=Grayscale_Output",
                          "=Compression",
                          "=File_Gamma",
                          "=Display_Gamma",
                          "UA=Output_Alpha",
                          "TH=Dither",
                          "=Dither_Method",
                          "L=Library_Path",
                          "HI=Include_Header",
                          "=Include_Ini",
                          "=Declare",
                          "K=Clock",
                          "KFI=Initial_Frame",
                          "KFF=Final_Frame",
                          "KI=Initial_Clock",
                          "KF=Final_Clock",
                          "SF=Subset_Start_Frame",
                          "EF=Subset_End_Frame",
                          "STP=Frame_Step",
                          "KC=Cyclic_Animation",
                          "KLA=Clockless_Animation",
                          "UF=Field_Render",
                          "UO=Odd_Field",
                          "SC=Start_Column",
                          "EC=End_Column",
                          "SR=Start_Row",
                          "ER=End_Row",
                          "C=Continue_Trace",
                          "WT=Work_Threads",
                          "B=Bounding",
                          "BM=Bounding_Method",
                          "MB=Bounding_Threshold",
                          "UV=Vista_Buffer",
                          "UL=Light_Buffer",
                          "UD=Draw_Vistas",
                          "UR=Remove_Bounds",
                          "SU=Split_Unions",
                          "BS=Render_Block_Size",
                          "RP=Render_Pattern",
                          "RS=Render_Block_Step",
                          "HR=High_Reproducibility",
                          "SP=Preview_Start_Size",
                          "EP=Preview_End_Size",
                          "MV=Version",
                          "MI=Max_Image_Buffer_Memory",
                          "=BSP_MaxDepth",
                          "=BSP_ISectCost",
                          "=BSP_BaseAccessCost",
                          "=BSP_ChildAccessCost",
                          "=BSP_MissChance",
                          "RFI=Radiosity_From_File",
                          "RFO=Radiosity_To_File",
                          "RF=Radiosity_File_Name",
                          "RVP=Radiosity_Vain_Pretrace",
                          "RTR=Real_Time_Raytracing",
                          "GA=All_Console",
                          "GD=Debug_Console",
                          "GF=Fatal_Console",
                          "GR=Render_Console",
                          "GS=Statistic_Console",
                          "GW=Warning_Console",
                          "=All_File",
                          "=Debug_File",
                          "=Fatal_File",
                          "=Render_File",
                          "=Statistic_File",
                          "=Warning_File",
                          "GP=Append_File",
                          "GI=Create_Ini",
                          "WL=Warning_Level",
                          "V=Verbose",
                          "X=Test_Abort",
                          "=Test_Abort_Count",
                          "=Pre_Scene_Command",
                          "=Pre_Frame_Command",
                          "=Post_Scene_Command",
                          "=Post_Frame_Command",
                          "=User_Abort_Command",
                          "=Fatal_Error_Command",
                          "=Pre_Scene_Return",
                          "=Pre_Frame_Return",
                          "=Post_Scene_Return",
                          "=Post_Frame_Return",
                          "=User_Abort_Return",
                          "=Fatal_Error_Return",
                          "=Buffer_Output",
                          "=Buffer_Size",
                          "=Create_Histogram",
                          "=Histogram_Name",
                          "=Histogram_Type",
                          "=Histogram_Grid_Size",
                          "=Palette",
                          "=Video_Mode",
                          "=Antialias_Threshold",
                          "=Jitter_Amount"}) {
    CAPTURE(row);
    const std::string_view letters(row, std::strchr(row, '=') - row);
    const Option* option = option_of_keyword(row + letters.size() + 1);
    REQUIRE(option != nullptr);
    CHECK(option->letters == letters);
  }
}

TEST_CASE("options: each is accepted as keyword and as switch, of either sign and case",
          "[cli][options]") {
  for (const Option& o : options()) {
    if (o.keyword == "Include_Ini") continue;  // needs a file: see the tests of INI files
    const std::string value = sample(o);
    accepted({std::string(o.keyword) + "=" + value});
    accepted({lower(o.keyword) + "=\"" + value + "\""});
    if (o.keyword == "Untrusted") continue;  // there is no way back: see the tests of limits
    if (o.letters.empty() || o.group == Group::not_yet) continue;
    const std::string attached = o.form == Form::value ? value : "";
    accepted({"+" + std::string(o.letters) + attached});
    accepted({"-" + lower(o.letters) + attached});
  }
}

TEST_CASE("options: every GNU name acts like its keyword", "[cli][options]") {
  for (const Option& o : options()) {
    if (o.long_name.empty() || o.keyword == "Include_Ini") continue;
    CAPTURE(o.long_name);
    const std::string name = "--" + std::string(o.long_name);
    const auto by_keyword = accepted({std::string(o.keyword) + "=" + sample(o)}).history;
    CHECK(accepted({name + "=" + sample(o)}).history == by_keyword);
    if (o.form == Form::flag) {
      CHECK(accepted({name}).history == by_keyword);
      CHECK(accepted({"--no-" + std::string(o.long_name)}).history.back().second == "off");
    } else {
      CHECK(accepted({name, sample(o)}).history == by_keyword);
    }
  }
}

TEST_CASE("options: what is not supported yet is an error that names it", "[cli][options]") {
  for (const Option& o : options()) {
    if (o.group != Group::not_yet) continue;
    const std::string on = o.form == Form::flag ? "on" : "x";
    const std::string message = refused({std::string(o.keyword) + "=" + on});
    CHECK(message.find(o.keyword) != std::string::npos);
    CHECK(message.find("not supported yet") != std::string::npos);
    if (!o.letters.empty())
      refused({"+" + std::string(o.letters) + (o.form == Form::flag ? "" : "x")});
  }
}

TEST_CASE("options: obsolete ones are read, with a warning", "[cli][options]") {
  for (const Option& o : options()) {
    const test::Result r = test::read({std::string(o.keyword) + "=" + sample(o)});
    CAPTURE(o.keyword, r.warnings);
    CHECK(r.warnings.size() == (o.group == Group::obsolete ? 1 : 0));
  }
}

TEST_CASE("options: defaults", "[cli][options]") {
  const Settings s = accepted({});
  CHECK(s.width == 800);
  CHECK(s.height == 600);
  CHECK_FALSE(s.antialias);
  CHECK(s.aa_threshold == 0.3);
  CHECK(s.aa_depth == 3);
  CHECK(s.jitter);
  CHECK(s.file_gamma == GammaCurve::srgb());
  CHECK(s.bits == 8);
  CHECK(s.write_output);
  CHECK(s.format == nullptr);
  CHECK_FALSE(check(s));
}

TEST_CASE("options: a sign with a value switches and stores", "[cli][options]") {
  Settings s = accepted({"+A0.1"});
  CHECK(s.antialias);
  CHECK(s.aa_threshold == 0.1);
  s = accepted({"-A0.2", "-J0.5"});
  CHECK_FALSE(s.antialias);
  CHECK(s.aa_threshold == 0.2);
  CHECK_FALSE(s.jitter);
  CHECK(s.jitter_amount == 0.5);
  CHECK(accepted({"+A", "-a"}).antialias == false);
}

TEST_CASE("options: values out of range move to its end, as in POV-Ray", "[cli][options]") {
  const Settings s = accepted({"+A7", "+J-1", "+R0", "+AM9", "+Q11", "+FN4", "+BS1"});
  CHECK(s.aa_threshold == 1);
  CHECK(s.jitter_amount == 0);
  CHECK(s.aa_depth == 1);
  CHECK(s.sampling_method == 2);
  CHECK(s.quality == 9);
  CHECK(s.bits == 5);
  CHECK(s.block_size == 4);
  CHECK(accepted({"+R99"}).aa_depth == 9);
  CHECK(accepted({"+FN17"}).bits == 16);
}

TEST_CASE("options: random paths want all of the scene", "[cli][options]") {
  const Settings s = accepted({"Integrator=path", "--samples=100", "Path_Bounces=0"});
  CHECK(s.paths);
  CHECK(s.path_samples == 100);
  CHECK(s.path_bounces == 0);
  CHECK_FALSE(check(s));
  CHECK_FALSE(accepted({"Integrator=path", "--integrator", "trace"}).paths);
  CHECK(check(accepted({"Integrator=path", "+Q8"})).has_value());
  CHECK(refused({"Integrator=paths"}).find("trace or path") != std::string::npos);
  refused({"--samples=0"});
}

TEST_CASE("options: sizes must be positive", "[cli][options]") {
  CHECK(refused({"+W0"}).find("whole number from 1") != std::string::npos);
  refused({"+H-3"});
  refused({"--size", "800x0"});
  const Settings s = accepted({"+W320", "-h200"});
  CHECK(s.width == 320);
  CHECK(s.height == 200);
  CHECK(accepted({"--size", "32x20"}).height == 20);
}

TEST_CASE("options: the output type holds letter, bits and greyscale", "[cli][options]") {
  Settings s = accepted({"+FN16g"});
  CHECK(s.format->name == "png");
  CHECK(s.bits == 16);
  CHECK(s.greyscale);
  s = accepted({"+fj"});
  CHECK(s.format->name == "jpeg");
  CHECK(s.bits == 8);
  CHECK(accepted({"+FPG"}).greyscale);
  CHECK(accepted({"+FE"}).format->name == "exr");
  CHECK(accepted({"+FS"}).format->name == "png");
  CHECK(accepted({"+FC"}).compressed_tga);
  CHECK_FALSE(accepted({"+FC", "+FT"}).compressed_tga);
  CHECK(accepted({"+F"}).write_output);
  CHECK(accepted({"+F"}).format == nullptr);
  CHECK_FALSE(accepted({"-F"}).write_output);
  CHECK_FALSE(accepted({"-FN"}).write_output);
  CHECK(accepted({"--format", "tiff"}).format->name == "tiff");
  CHECK(refused({"+FM"}).find("unknown type `M`") != std::string::npos);
  refused({"+F8"});
  refused({"+FN8x"});
  refused({"--format", "gif"});
}

TEST_CASE("options: curves", "[cli][options]") {
  CHECK(accepted({"File_Gamma=1.0"}).file_gamma == GammaCurve());
  CHECK(accepted({"file_gamma=srgb"}).file_gamma == GammaCurve::srgb());
  refused({"File_Gamma=0"});
}

TEST_CASE("options: declarations keep full precision, strings and their order", "[cli][options]") {
  const auto d = accepted({"Declare=A=0.123456789", "declare=B=\"x y\"", "--declare", "A=2",
                           "Declare= C = 0x10"})
                     .declares;
  REQUIRE(d.size() == 4);
  CHECK(d[0] == std::pair<std::string, std::variant<double, std::string>>("A", 0.123456789));
  CHECK(std::get<std::string>(d[1].second) == "x y");
  CHECK(std::get<double>(d[2].second) == 2);
  CHECK(d[3].first == "C");
  CHECK(std::get<double>(d[3].second) == 16);
  for (const char* bad :
       {"Declare=A", "Declare=A=", "Declare==1", "Declare=1A=1", "Declare=A=1+1"}) {
    refused({bad});
  }
}

TEST_CASE("options: clock and version", "[cli][options]") {
  CHECK_FALSE(accepted({}).clock_given);
  CHECK(accepted({"+K.5"}).clock == 0.5);
  CHECK(accepted({"-K.5"}).clock_given);
  CHECK(accepted({"Version=3.6"}).version == 360);
  CHECK(accepted({"+MV3.7"}).version == 370);
  refused({"+MV3.8"});
  refused({"+K"});
}

TEST_CASE("options: message streams", "[cli][options]") {
  const auto console = [](const Settings& s, Stream stream) {
    return s.streams[static_cast<std::size_t>(stream)].console;
  };
  Settings s = accepted({"-GA", "+GDdebug.txt"});
  CHECK(console(s, Stream::debug));
  CHECK_FALSE(console(s, Stream::warning));
  CHECK(s.streams[static_cast<std::size_t>(Stream::debug)].file == "debug.txt");
  s = accepted({"+GAall.txt", "-GW", "+GP"});
  CHECK(s.all_file == "all.txt");
  CHECK_FALSE(console(s, Stream::warning));
  CHECK(console(s, Stream::fatal));
  CHECK(s.append_files);
  CHECK(accepted({"-V"}).verbose == false);
}

TEST_CASE("options: checked as a whole, what is missing is named", "[cli][options]") {
  const auto problem = [](const std::vector<std::string>& words) {
    return check(accepted(words)).value_or("");
  };
  CHECK(problem({"+Q8"}).empty());
  CHECK(problem({"+A", "+AM2"}).empty());
  CHECK(problem({"+AM2"}).empty());  // without anti-aliasing it changes nothing
  CHECK(problem({"+KFI1", "+KFF10"}).empty());
}

}  // namespace durer::cli
