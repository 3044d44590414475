#include "cli/options.h"

#include <array>

#include "cli/apply.h"
#include "cli/limits.h"

namespace durer::cli {
namespace {

using namespace std::string_view_literals;
using S = Settings;

// clang-format off
constexpr std::array table = {
// Files
Option{"Input_File_Name",    "I",  Form::value, "", "input", "file", "the scene; `.pov` and `.scene` are tried; `-`: standard input", Group::files, apply::input},
Option{"Output_File_Name",   "O",  Form::value, "", "output", "file", "the picture; the extension chooses the type unless one is given; a folder ends in `/`; `-`: standard output", Group::files, apply::text<&S::output>},
Option{"Output_To_File",     "F",  Form::type,  "Output_File_Type", "", "[t][n][g]", "write a file: type letter, bits per channel, `g` for greyscale; `-F`: write nothing", Group::files, apply::boolean<&S::write_output>},
Option{"Output_File_Type",   "",   Form::value, "", "format", "type", "N png, T tga, C compressed tga, J jpeg, P ppm, B bmp, E exr, H hdr, S png; or a name, tiff too", Group::files, apply::output_type},
Option{"Bits_Per_Color",     "",   Form::value, "", "bits", "n", "bits per channel, 5 to 16, where the type has a choice", Group::files, apply::clamped_whole<&S::bits, 5, 16>},
Option{"Grayscale_Output",   "",   Form::flag,  "", "greyscale", "", "write grey levels only; PNG then has 16 bits", Group::files, apply::boolean<&S::greyscale>},
Option{"Output_Alpha",       "UA", Form::flag,  "", "alpha", "", "write an alpha channel where the type has one", Group::files, apply::boolean<&S::alpha>},
Option{"Compression",        "",   Form::value, "", "compression", "n", "JPEG quality 0 to 100, PNG effort 0 to 9", Group::files, apply::whole<&S::compression, 0, 100>},
Option{"Dither",             "TH", Form::flag,  "Dither_Method", "dither", "[m]", "hide the rounding to few levels; default off", Group::files, apply::boolean<&S::dither>},
Option{"Dither_Method",      "",   Form::value, "", "", "m", "B2 B3 B4 patterns of 2x2 to 4x4 pixels, D1 D2 FS errors go to 1, 3 or 4 neighbours; default FS", Group::files, apply::dither_method},
Option{"File_Gamma",         "",   Form::value, "", "file-gamma", "curve", "curve of the file: sRGB or an exponent; EXR and HDR are always linear", Group::files, apply::file_gamma},
Option{"Library_Path",       "L",  Form::value, "", "include-path", "folder", "search this folder for includes and INI files; repeatable", Group::files, apply::library_path},
Option{"Include_Ini",        "",   Form::value, "", "ini", "file", "read this INI file, or one section of it: file[section]", Group::files, nullptr},
Option{"Create_Ini",         "GI", Form::value, "", "", "file", "write the settings in force to an INI file", Group::files, apply::text<&S::create_ini>},

// Size
Option{"Width",              "W",  Form::value, "", "width", "n", "pixels across; default 800", Group::size, apply::whole<&S::width, 1, 65535>},
Option{"Height",             "H",  Form::value, "", "height", "n", "pixels down; default 600", Group::size, apply::whole<&S::height, 1, 65535>},
Option{"Size",               "",   Form::value, "", "size", "WxH", "both at once: 800x600", Group::size, apply::size},
Option{"Start_Column",       "SC", Form::value, "", "", "n", "first column to render, from 1, or a fraction below 1", Group::size, apply::place<&S::start_column>},
Option{"End_Column",         "EC", Form::value, "", "", "n", "last column to render, or a fraction up to 1", Group::size, apply::place<&S::end_column>},
Option{"Start_Row",          "SR", Form::value, "", "", "n", "first row to render", Group::size, apply::place<&S::start_row>},
Option{"End_Row",            "ER", Form::value, "", "", "n", "last row to render", Group::size, apply::place<&S::end_row>},

// Sampling
Option{"Antialias",          "A",  Form::flag,  "Antialias_Threshold", "antialias", "[x]", "anti-aliasing, with its threshold; default off, 0.3", Group::sampling, apply::boolean<&S::antialias>},
Option{"Antialias_Threshold","",   Form::value, "", "", "x", "refine where neighbours differ by this, 0 to 1", Group::sampling, apply::fraction<&S::aa_threshold>},
Option{"Sampling_Method",    "AM", Form::value, "", "", "n", "0 none, 1 n*n+1 samples where neighbours differ, 2 pixels are divided where their corners differ", Group::sampling, apply::clamped_whole<&S::sampling_method, 0, 2>},
Option{"Antialias_Depth",    "R",  Form::value, "", "", "n", "n in n*n+1 samples, or at most n-1 divisions; 1 to 9, default 3", Group::sampling, apply::clamped_whole<&S::aa_depth, 1, 9>},
Option{"Jitter",             "J",  Form::flag,  "Jitter_Amount", "", "[x]", "move the samples at random, by this share of their distance; default on, 1", Group::sampling, apply::boolean<&S::jitter>},
Option{"Jitter_Amount",      "",   Form::value, "", "", "x", "0 to 1", Group::sampling, apply::fraction<&S::jitter_amount>},
Option{"Antialias_Gamma",    "AG", Form::value, "", "", "x", "curve in which neighbours are compared; default 2.5", Group::sampling, apply::aa_gamma},
Option{"Quality",            "Q",  Form::value, "", "", "n", "9: everything; 8: no media, 7: no reflection and bumps, 5: no transparency, 4: no area lights, 3: no shadows, 1: pigments only", Group::sampling, apply::clamped_whole<&S::quality, 0, 9>},
Option{"Render_Block_Size",  "BS", Form::value, "", "", "n", "pixels; anti-aliasing compares within blocks of this size; default 32", Group::sampling, apply::clamped_whole<&S::block_size, 4, 65535>},
Option{"Integrator",         "",   Form::value, "", "integrator", "trace|path", "how light is found: as POV-Ray does it, or along random paths, with all light from all surfaces", Group::sampling, apply::integrator},
Option{"Path_Samples",       "",   Form::value, "", "samples", "n", "random paths per pixel; default 64; four times as many halve the noise", Group::sampling, apply::whole<&S::path_samples, 1, 16777216>},
Option{"Path_Bounces",       "",   Form::value, "", "max-bounces", "n", "surfaces that a random path may come from; default 64; 1: only light straight from its source", Group::sampling, apply::whole<&S::path_bounces, 0, 65535>},
Option{"Work_Threads",       "WT", Form::value, "", "threads", "n", "threads; default one per processor", Group::sampling, apply::clamped_whole<&S::threads, 1, 512>},

// What the scene sees
Option{"Declare",            "",   Form::pair,  "", "declare", "name=value", "declare a number or a \"string\" before the scene is read; the first of a name wins", Group::world, apply::declare},
Option{"Include_Header",     "HI", Form::value, "", "", "file", "read this file before the scene", Group::world, apply::text<&S::header_file>},
Option{"Clock",              "K",  Form::value, "", "clock", "x", "value of `clock`", Group::world, apply::clock},
Option{"Version",            "MV", Form::value, "", "", "x", "language version in force at the start", Group::world, apply::version},

// Animation
Option{"Initial_Frame",      "KFI",Form::value, "", "", "n", "first frame; 0 and 0, or 1 and 1, mean a still picture", Group::animation, apply::whole<&S::initial_frame, -2147483647, 2147483646>},
Option{"Final_Frame",        "KFF",Form::value, "", "", "n", "last frame; all are rendered by one process", Group::animation, apply::whole<&S::final_frame, -2147483647, 2147483646>},
Option{"Initial_Clock",      "KI", Form::value, "", "", "x", "clock of the first frame; default 0", Group::animation, apply::number<&S::initial_clock>},
Option{"Final_Clock",        "KF", Form::value, "", "", "x", "clock of the last frame; default 1", Group::animation, apply::number<&S::final_clock>},
Option{"Subset_Start_Frame", "SF", Form::value, "", "", "n", "first frame to render, or a fraction of them all", Group::animation, apply::place<&S::subset_start>},
Option{"Subset_End_Frame",   "EF", Form::value, "", "", "n", "last frame to render, or a fraction of them all", Group::animation, apply::place<&S::subset_end>},
Option{"Frame_Step",         "STP",Form::value, "", "", "n", "render every n-th frame", Group::animation, apply::clamped_whole<&S::frame_step, 1, 2147483646>},
Option{"Cyclic_Animation",   "KC", Form::flag,  "", "", "", "the clock would reach its end one frame after the last", Group::animation, apply::boolean<&S::cyclic>},
Option{"Continue_Trace",     "C",  Form::flag,  "", "continue", "", "skip frames whose picture is there; take an interrupted picture up again", Group::animation, apply::boolean<&S::continue_trace>},

// Shell commands
Option{"Pre_Scene_Command",  "",   Form::value, "", "", "cmd", "run this before everything; %o output, %s scene, %n frame, %k clock, %w %h size, %% a %", Group::shell, apply::shell_command<Moment::pre_scene>},
Option{"Pre_Frame_Command",  "",   Form::value, "", "", "cmd", "run this before each frame", Group::shell, apply::shell_command<Moment::pre_frame>},
Option{"Post_Frame_Command", "",   Form::value, "", "", "cmd", "run this after each frame", Group::shell, apply::shell_command<Moment::post_frame>},
Option{"Post_Scene_Command", "",   Form::value, "", "", "cmd", "run this after everything", Group::shell, apply::shell_command<Moment::post_scene>},
Option{"User_Abort_Command", "",   Form::value, "", "", "cmd", "run this after an interruption", Group::shell, apply::shell_command<Moment::user_abort>},
Option{"Fatal_Error_Command","",   Form::value, "", "", "cmd", "run this after an error", Group::shell, apply::shell_command<Moment::fatal_error>},
Option{"Pre_Scene_Return",   "",   Form::value, "", "", "r", "if the command fails (after a `-`: succeeds): I go on, S skip the frames, A skip everything, Q quit, U interrupt, F fail", Group::shell, apply::shell_return<Moment::pre_scene>},
Option{"Pre_Frame_Return",   "",   Form::value, "", "", "r", "likewise; S skips this frame, A this and all that follow", Group::shell, apply::shell_return<Moment::pre_frame>},
Option{"Post_Frame_Return",  "",   Form::value, "", "", "r", "likewise; A skips all frames that follow", Group::shell, apply::shell_return<Moment::post_frame>},
Option{"Post_Scene_Return",  "",   Form::value, "", "", "r", "likewise; S and A have nothing left to skip", Group::shell, apply::shell_return<Moment::post_scene>},
Option{"User_Abort_Return",  "",   Form::value, "", "", "r", "likewise; Q, U and F choose the exit code 0, 2 or 1", Group::shell, apply::shell_return<Moment::user_abort>},
Option{"Fatal_Error_Return", "",   Form::value, "", "", "r", "likewise", Group::shell, apply::shell_return<Moment::fatal_error>},

// Limits
Option{"Untrusted",          "",   Form::flag,  "", "untrusted", "", "for scenes of strangers: all limits below, files only where they belong, no shell commands", Group::limits, apply::untrusted},
Option{"Max_Macro_Depth",    "",   Form::value, "", "max-macro-depth", "n", "macro calls inside one another; default 1000, untrusted 200", Group::limits, apply::whole<&S::max_macro_depth, 1, 1000000>},
Option{"Max_Include_Depth",  "",   Form::value, "", "max-include-depth", "n", "files inside one another; default 100, untrusted 20", Group::limits, apply::whole<&S::max_include_depth, 1, 1000000>},
Option{"Max_Loop_Turns",     "",   Form::value, "", "max-loop-turns", "n", "turns of all loops and macro calls together; untrusted 10 million", Group::limits, apply::positive<&S::max_loop_turns>},
Option{"Max_Seconds",        "",   Form::value, "", "max-seconds", "x", "time to read the scene, for each frame; untrusted 30", Group::limits, apply::positive<&S::max_seconds>},
Option{"Max_Render_Seconds", "",   Form::value, "", "max-render-seconds", "x", "time to render each frame; untrusted 600", Group::limits, apply::positive<&S::max_render_seconds>},
Option{"Max_Memory",         "",   Form::value, "", "max-memory", "n", "megabytes that the program may hold; untrusted 4096", Group::limits, apply::positive<&S::max_memory>},
Option{"Max_Pixels",         "",   Form::value, "", "max-pixels", "n", "width times height; untrusted 40 million", Group::limits, apply::positive<&S::max_pixels>},
Option{"Max_Frames",         "",   Form::value, "", "max-frames", "n", "frames of an animation; untrusted 10000", Group::limits, apply::whole<&S::max_frames, 1, 2147483647>},

// Looking into scenes
Option{"Dump_Scene",         "",   Form::flag,  "", "dump-scene", "[=text|json]", "print the scene as data and stop", Group::debugging, apply::dump_scene},
Option{"Trace_Macros",       "",   Form::flag,  "", "trace-macros", "", "print every macro call and return", Group::debugging, apply::boolean<&S::trace_macros>},
Option{"Diagnostics",        "",   Form::value, "", "diagnostics", "text|json", "how messages look: for people, or one JSON object a line for programs", Group::debugging, apply::diagnostics_format},

// Messages
Option{"Quiet",              "",   Form::flag,  "", "quiet", "", "print errors only", Group::messages, apply::boolean<&S::quiet>},
Option{"Show",               "",   Form::flag,  "", "show", "", "draw the finished picture in the terminal", Group::messages, apply::boolean<&S::show>},
Option{"Verbose",            "V",  Form::flag,  "", "", "", "show progress; default on", Group::messages, apply::boolean<&S::verbose>},
Option{"Warning_Level",      "WL", Form::value, "", "", "n", "0: no warnings", Group::messages, apply::whole<&S::warning_level, 0, 10>},
Option{"All_Console",        "GA", Form::flag,  "All_File", "", "[file]", "all five message streams on the console, with a copy in a file", Group::messages, apply::all_console},
Option{"Debug_Console",      "GD", Form::flag,  "Debug_File", "", "[file]", "messages of #debug", Group::messages, apply::console<Stream::debug>},
Option{"Fatal_Console",      "GF", Form::flag,  "Fatal_File", "", "[file]", "errors", Group::messages, apply::console<Stream::fatal>},
Option{"Render_Console",     "GR", Form::flag,  "Render_File", "", "[file]", "what was assumed, and progress", Group::messages, apply::console<Stream::render>},
Option{"Statistic_Console",  "GS", Form::flag,  "Statistic_File", "", "[file]", "the closing line", Group::messages, apply::console<Stream::statistic>},
Option{"Warning_Console",    "GW", Form::flag,  "Warning_File", "", "[file]", "warnings", Group::messages, apply::console<Stream::warning>},
Option{"All_File",           "",   Form::value, "", "", "file", "copy of all streams", Group::messages, apply::text<&S::all_file>},
Option{"Debug_File",         "",   Form::value, "", "", "file", "copy of the debug stream", Group::messages, apply::stream_file<Stream::debug>},
Option{"Fatal_File",         "",   Form::value, "", "", "file", "copy of the errors", Group::messages, apply::stream_file<Stream::fatal>},
Option{"Render_File",        "",   Form::value, "", "", "file", "copy of the render stream", Group::messages, apply::stream_file<Stream::render>},
Option{"Statistic_File",     "",   Form::value, "", "", "file", "copy of the statistic stream", Group::messages, apply::stream_file<Stream::statistic>},
Option{"Warning_File",       "",   Form::value, "", "", "file", "copy of the warnings", Group::messages, apply::stream_file<Stream::warning>},
Option{"Append_File",        "GP", Form::flag,  "", "", "", "append to those files instead of replacing them", Group::messages, apply::boolean<&S::append_files>},

// Accepted, without effect on the picture
Option{"Display",            "D",  Form::flag,  "Palette", "", "[xy]", "preview window", Group::no_effect, apply::ignored_boolean},
Option{"Pause_When_Done",    "P",  Form::flag,  "", "", "", "wait before the preview closes", Group::no_effect, apply::ignored_boolean},
Option{"Display_Gamma",      "",   Form::value, "", "", "curve", "curve of the preview", Group::no_effect, apply::ignored_text},
Option{"Bounding",           "B",  Form::flag,  "", "", "", "there is always a hierarchy", Group::no_effect, apply::ignored_boolean},
Option{"Bounding_Method",    "BM", Form::value, "", "", "n", "kind of hierarchy", Group::no_effect, apply::ignored_number},
Option{"Bounding_Threshold", "MB", Form::value, "", "", "n", "size from which there is a hierarchy", Group::no_effect, apply::ignored_number},
Option{"Vista_Buffer",       "UV", Form::flag,  "", "", "", "", Group::no_effect, apply::ignored_boolean},
Option{"Light_Buffer",       "UL", Form::flag,  "", "", "", "", Group::no_effect, apply::ignored_boolean},
Option{"Draw_Vistas",        "UD", Form::flag,  "", "", "", "", Group::no_effect, apply::ignored_boolean},
Option{"Remove_Bounds",      "UR", Form::flag,  "", "", "", "drop redundant bounds", Group::no_effect, apply::ignored_boolean},
Option{"Split_Unions",       "SU", Form::flag,  "", "", "", "split bounded unions", Group::no_effect, apply::ignored_boolean},
Option{"Render_Pattern",     "RP", Form::value, "", "", "n", "order of blocks", Group::no_effect, apply::ignored_number},
Option{"Render_Block_Step",  "RS", Form::value, "", "", "n", "order of blocks", Group::no_effect, apply::ignored_number},
Option{"High_Reproducibility","HR",Form::flag,  "", "", "", "pictures are always reproducible", Group::no_effect, apply::ignored_boolean},
Option{"Preview_Start_Size", "SP", Form::value, "", "", "n", "mosaic preview", Group::no_effect, apply::ignored_number},
Option{"Preview_End_Size",   "EP", Form::value, "", "", "n", "mosaic preview", Group::no_effect, apply::ignored_number},
Option{"Max_Image_Buffer_Memory","MI",Form::value,"","", "n", "megabytes before pictures go to disk", Group::no_effect, apply::ignored_number},
Option{"BSP_MaxDepth",       "",   Form::value, "", "", "x", "", Group::no_effect, apply::ignored_number},
Option{"BSP_ISectCost",      "",   Form::value, "", "", "x", "", Group::no_effect, apply::ignored_number},
Option{"BSP_BaseAccessCost", "",   Form::value, "", "", "x", "", Group::no_effect, apply::ignored_number},
Option{"BSP_ChildAccessCost","",   Form::value, "", "", "x", "", Group::no_effect, apply::ignored_number},
Option{"BSP_MissChance",     "",   Form::value, "", "", "x", "", Group::no_effect, apply::ignored_number},
Option{"Field_Render",       "UF", Form::flag,  "", "", "", "ignored, as in POV-Ray 3.7", Group::no_effect, apply::ignored_boolean},
Option{"Odd_Field",          "UO", Form::flag,  "", "", "", "ignored, as in POV-Ray 3.7", Group::no_effect, apply::ignored_boolean},
Option{"Radiosity_Vain_Pretrace","RVP",Form::flag,"","", "", "show the pretrace of radiosity", Group::no_effect, apply::ignored_boolean},
Option{"Radiosity_File_Name","RF", Form::value, "", "", "file", "used by the two options of radiosity below", Group::no_effect, apply::ignored_text},
Option{"Real_Time_Raytracing","RTR",Form::flag, "", "", "", "", Group::no_effect, apply::ignored_boolean},
Option{"Test_Abort",         "X",  Form::flag,  "Test_Abort_Count", "", "[n]", "every render can be interrupted", Group::no_effect, apply::ignored_boolean},
Option{"Test_Abort_Count",   "",   Form::value, "", "", "n", "", Group::no_effect, apply::ignored_number},
Option{"Palette",            "",   Form::value, "", "", "x", "of the preview", Group::no_effect, apply::ignored_text},
Option{"Video_Mode",         "",   Form::value, "", "", "x", "of the preview", Group::no_effect, apply::ignored_text},

// Obsolete, with a warning
Option{"Buffer_Output",      "",   Form::flag,  "", "", "", "", Group::obsolete, apply::ignored_boolean},
Option{"Buffer_Size",        "",   Form::value, "", "", "n", "", Group::obsolete, apply::ignored_number},
Option{"Create_Histogram",   "",   Form::flag,  "", "", "", "", Group::obsolete, apply::ignored_boolean},
Option{"Histogram_Name",     "",   Form::value, "", "", "file", "", Group::obsolete, apply::ignored_text},
Option{"Histogram_Type",     "",   Form::value, "", "", "t", "", Group::obsolete, apply::ignored_text},
Option{"Histogram_Grid_Size","",   Form::value, "", "", "x", "", Group::obsolete, apply::ignored_text},

// Known, and an error when switched on
Option{"Clockless_Animation","KLA",Form::flag,  "", "", "", "several cameras as frames", Group::not_yet, apply::only_off},
Option{"Radiosity_From_File","RFI",Form::flag,  "", "", "", "read radiosity samples", Group::not_yet, apply::only_off},
Option{"Radiosity_To_File",  "RFO",Form::flag,  "", "", "", "write radiosity samples", Group::not_yet, apply::only_off},
};
// clang-format on

}  // namespace

std::span<const Option> options() { return table; }

const Option* option_of_keyword(std::string_view keyword) {
  for (const Option& o : table) {
    if (same_word(o.keyword, keyword)) return &o;
  }
  return nullptr;
}

const Option* option_of_switch(std::string_view text) {
  const Option* best = nullptr;
  for (const Option& o : table) {
    if (o.letters.empty() || !same_word(o.letters, text.substr(0, o.letters.size()))) continue;
    if (!best || o.letters.size() > best->letters.size()) best = &o;
  }
  return best;
}

Problem check(const Settings& s) {
  if (s.paths && s.quality < 9) return "random paths leave nothing out: Integrator=path needs Quality=9";
  return check_untrusted(s);
}

}  // namespace durer::cli
