// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <functional>
#include <utility>

#include "help.h"
#include "parse.h"
#include "rimline/formats.h"
#include "rimline/version.h"

namespace rimline::cli {
namespace {

constexpr int most_threads = 1024;
const std::vector<std::string> panel_names = {"points",   "candidates", "probability", "chromosome",
                                              "boundary", "map",        "mesh"};
constexpr int least_panel = 100, most_panel = 1240;

template <class T>
std::string text_of(const T& value) {
  if constexpr (std::is_enum_v<T>) {
    return name(value);
  } else if constexpr (std::same_as<T, bool>) {
    return value ? "on" : "off";
  } else {
    return fmt::format("{}", value);
  }
}

template <class T>
std::string range_of(const Field<T>& field) {
  if constexpr (std::is_enum_v<T>) {
    return fmt::format("One of {}.", fmt::join(names_of<T>(), ", "));
  } else if constexpr (std::same_as<T, bool>) {
    return "on or off.";
  } else if constexpr (std::is_arithmetic_v<T>) {
    if (field.zero[0] != 0) return fmt::format("{}, or from 1 to {}.", field.zero, field.most);
    return fmt::format("From {} to {}.", field.least, field.most);
  } else {
    return "";
  }
}

// "Default 40." or "Default capped; paper-log: log.": of the presets that use the field.
template <class T>
std::string default_text(const Field<T>& field) {
  std::string text, standard;
  for (const auto& preset_name : names_of<Preset>()) {
    Options options = preset_options(parse_enum<Preset>("--preset", preset_name));
    if (field.used_by == UsedBy::Capped) options.loops.score_form = ScoreForm::Capped;
    if (!counts(field.used_by, options)) continue;
    std::string value;
    visit_fields(options, [&](const auto& candidate) {
      if (std::string_view(candidate.name) != field.name) return;
      const bool is_word = candidate.zero[0] != 0 && text_of(candidate.value) == "0";
      value = is_word ? candidate.zero : text_of(candidate.value);
    });
    if (text.empty()) text = "Default " + (standard = value);
    if (value != standard) text += fmt::format("; {}: {}", preset_name, value);
  }
  return text + ".";
}

// "Of the preset default alone. Default 6."
template <class T>
std::string where_and_default(const Field<T>& field) {
  std::string where = where_used(field.used_by);
  if (where.empty()) return default_text(field);
  where.front() = 'O';
  return where + ". " + default_text(field);
}

template <class Struct>
bool holds(const Struct& options, const void* field) {
  const auto begin = reinterpret_cast<std::uintptr_t>(&options);
  const auto place = reinterpret_cast<std::uintptr_t>(field);
  return place >= begin && place < begin + sizeof(Struct);
}

// The heading under which --help lists a field: the struct that holds it.
std::string group_of(const Options& options, const void* field) {
  if (holds(options.boundary, field)) return "Boundary test (section 2)";
  if (holds(options.loops, field)) return "Loops (section 3)";
  if (holds(options.boundary_loops, field)) return "Boundary loops (preset default)";
  if (holds(options.map, field)) return "Map (section 5)";
  return "Mesh (section 5)";
}

void add_fields(CLI::App& command, MethodArguments& arguments) {
  Options options = preset_options(Preset::Default);
  visit_fields(options, [&](auto field) {
    using T = std::remove_reference_t<decltype(field.value)>;
    if constexpr (std::same_as<T, bool>) {
      command
          .add_flag_callback(
              flag_name(field.name),
              [&arguments, id = std::string(field.name)] { arguments.fields[id] = "on"; },
              fmt::format("{}. {}", field.help, where_and_default(field)))
          ->group(group_of(options, &field.value));
      return;
    }
    const bool has_word = field.zero[0] != 0;
    const std::string value = has_word                ? fmt::format("{}|N", field.zero)
                              : std::is_enum_v<T>     ? "NAME"
                              : std::is_integral_v<T> ? "N"
                                                      : "X";
    const std::string description =
        fmt::format("{}. {} {}", field.help, range_of(field), where_and_default(field));
    // Parses here only to refuse a bad value at once; options() parses it again, over the chosen preset.
    auto check = [&arguments, id = std::string(field.name)](const std::string& text) {
      Options trial;
      visit_fields(trial, [&](const auto& candidate) {
        if (candidate.name == id) parse_field(candidate, text);
      });
      arguments.fields[id] = text;
    };
    add_parsed(command, flag_name(field.name), value, description, group_of(options, &field.value), check);
  });
}

[[noreturn]] void refuse(const std::string& flag, UsedBy used_by, const Options& options) {
  const std::string chosen = used_by == UsedBy::Capped && counts(UsedBy::Paper, options)
                                 ? std::string("score form ") + name(options.loops.score_form)
                                 : std::string("preset ") + name(options.preset);
  throw Error(ErrorCode::BadOption,
              fmt::format("{} is {}; the {} does not use it", flag, where_used(used_by), chosen));
}

// Refuses options that were given and have no effect.
void check_counts(const MethodArguments& arguments, const Options& options) {
  const bool has_loops = !arguments.use_loops.empty();
  const auto check = [&](const std::string& flag, UsedBy used_by) {
    if (!counts(used_by, options)) refuse(flag, used_by, options);
  };
  visit_fields(options, [&](const auto& field) {
    if (!arguments.fields.contains(field.name)) return;
    check(flag_name(field.name), field.used_by);
    const bool searches = field.used_by == UsedBy::Paper && holds(options.loops, &field.value) &&
                          static_cast<const void*>(&field.value) != &options.loops.score_form;
    if (has_loops && searches) {
      throw Error(ErrorCode::BadOption,
                  flag_name(field.name) + " is for the search of a loop; --use-loops gives the loops");
    }
  });
  if (arguments.holes) check("--holes", UsedBy::Default);
  if (arguments.corners) check("--corners", UsedBy::Default);
  if (arguments.history.empty()) return;
  check("--history", UsedBy::Paper);
  if (has_loops)
    throw Error(ErrorCode::BadOption, "--history is of the search of a loop; --use-loops gives the loops");
}

}  // namespace

Options MethodArguments::options() const {
  Options result = preset_options(preset);
  visit_fields(result, [this](const auto& field) {
    const auto given = fields.find(field.name);
    if (given != fields.end()) parse_field(field, given->second);
  });
  if (up) result.mesh.up = *up;
  if (holes) result.mesh.holes = *holes;
  if (corners) result.map.corners = *corners;
  check_counts(*this, result);
  return result;
}

std::vector<std::string> MethodArguments::flags_of_mesh() const {
  std::vector<std::string> flags;
  const Options options = preset_options(preset);
  visit_fields(options, [&](const auto& field) {
    const bool of_mesh = holds(options.map, &field.value) || holds(options.mesh, &field.value);
    if (of_mesh && fields.contains(field.name)) flags.push_back(flag_name(field.name));
  });
  if (holes) flags.emplace_back("--holes");
  if (corners) flags.emplace_back("--corners");
  return flags;
}

CLI::App& add_subcommand(CLI::App& tool, const std::string& name, const std::string& description,
                         const std::string& example) {
  CLI::App& command = *tool.add_subcommand(name, description);
  command.footer(example);
  command.formatter_fn(
      [](const CLI::App* app, const std::string&, CLI::AppFormatMode) { return help_of_subcommand(*app); });
  command.set_help_flag("-h,--help", "Print this and end")->group("Run");
  command.set_version_flag("--version", std::string("rimline ") + version, "Print the version and end")
      ->group("Run");
  return command;
}

CLI::Option* add_parsed(CLI::App& command, const std::string& flags, const std::string& value,
                        const std::string& description, const std::string& group,
                        std::function<void(const std::string&)> parse) {
  return command.add_option_function<std::string>(flags, std::move(parse), description)
      ->type_name(value)
      ->group(group);
}

CLI::Option* add_path(CLI::App& command, const std::string& flags, std::string& path,
                      const std::string& value, const std::string& description) {
  const auto take = [&path, flags, value](const std::string& text) {
    const std::string flag = flags.substr(flags.find("--") == std::string::npos ? 0 : flags.find("--"));
    if (text.empty()) {
      throw Error(ErrorCode::BadOption,
                  fmt::format("{} wants the name of a file, not ''", flag.starts_with("-") ? flag : value));
    }
    path = text;
  };
  return add_parsed(command, flags, value, description, "Files", take);
}

void add_common(CLI::App& command, Common& common) {
  const std::string group = "Run";
  add_parsed(command, "--seed", "N", "Start of every random stream. From 0 to 2^64 - 1. Default 1.", group,
             [&](const std::string& text) { common.seed = parse_seed("--seed", text); });
  add_parsed(command, "--threads", "N",
             fmt::format("Most threads at once, 0 for all cores; the result does not depend on it. "
                         "From 0 to {}. Default 0.",
                         most_threads),
             group, [&](const std::string& text) {
               common.threads = static_cast<int>(parse_whole("--threads", text, 0, most_threads));
             });
  add_parsed(command, "--memory-limit", "BYTES",
             "Refuse, with the estimate, what would need more memory; 1.5M and 12G are understood, 0 sets no "
             "limit. Default 0.",
             group,
             [&](const std::string& text) { common.memory_limit = parse_bytes("--memory-limit", text); });
  command.add_flag("-q,--quiet", common.quiet, "Print nothing but errors and what was asked for as output")
      ->group(group);
}

void add_input(CLI::App& command, Input& input) {
  add_path(command, "input", input.path, "IN",
           fmt::format("Points: {}; - reads standard input", names_of_formats(FormatUse::ReadPoints)))
      ->required();
  add_parsed(command, "--class", "N,N,...",
             "Take the points of these classes alone, 2 being the ground of airborne scans. From 0 to 255. "
             "Default: all.",
             "Files",
             [&input](const std::string& text) { input.filter.classes = parse_classes("--class", text); });
  add_parsed(
      command, "--returns", "NAME",
      fmt::format("Take these returns of each pulse: {}. Default all.", fmt::join(names_of<Returns>(), ", ")),
      "Files",
      [&input](const std::string& text) { input.filter.returns = parse_enum<Returns>("--returns", text); });
}

void add_output(CLI::App& command, std::string& output, const std::string& value,
                const std::string& description, bool required) {
  CLI::Option* option = add_path(command, "-o,--output", output, value, description);
  if (required) option->required();
}

void add_method(CLI::App& command, MethodArguments& arguments) {
  const std::string files = "Files";
  add_path(command, "--loops", arguments.loops, "LOOPS.json",
           fmt::format("Write the loops, by the ending: {}; - is JSON on standard output",
                       text_of_endings(FormatUse::WriteLoops)));
  add_path(command, "--use-loops", arguments.use_loops, "IN.json",
           "Take the boundary from this file instead of finding one; only `points` of each loop is needed");
  add_path(command, "--report", arguments.report, "REPORT.json",
           "Write options, counts, measures, seconds and memory (JSON); - for standard output");
  add_path(
      command, "--history", arguments.history, "HISTORY.json",
      "Write the best chromosome of every generation (JSON); - for standard output. Of the presets paper and "
      "paper-log alone.");
  add_path(command, "--picture", arguments.picture, "OUT.png|svg", "Draw what was found, stage by stage");
  add_parsed(command, "--picture-size", "N",
             fmt::format("Width and height of each of its panels in pixels. From {} to {}. Default {}.",
                         least_panel, most_panel, arguments.picture_size),
             files, [&](const std::string& text) {
               arguments.picture_size =
                   static_cast<int>(parse_whole("--picture-size", text, least_panel, most_panel));
             });
  add_parsed(command, "--panels", "NAME,...",
             fmt::format("The panels of --picture and their order: {}. Default: all that the run has.",
                         fmt::join(panel_names, ", ")),
             files,
             [&](const std::string& text) { arguments.panels = parse_list("--panels", text, panel_names); });
  add_parsed(command, "--up", "X,Y,Z",
             "The mesh faces this way on average where the points have no normals, and the picture stands "
             "this way. Default 0,0,1.",
             "Mesh (section 5)",
             [&](const std::string& text) { arguments.up = parse_direction("--up", text); });
  add_parsed(command, "--viewpoint", "X,Y,Z",
             "Where the scanner stood: depths along its rays may be in steps. Default: the axes and the "
             "origin are tried.",
             files, [&](const std::string& text) { arguments.viewpoint = parse_place("--viewpoint", text); });
  add_parsed(command, "--holes", "keep|fill|fill:MAX",
             "Holes that are filled by triangles; the others are loops of the mesh's boundary. fill:30 fills "
             "those of at most 30 points, fill:2.5u those whose rim is at most 2.5 long, in units of the "
             "input [ours]. Of the preset default alone; the others fill all through the map. Default keep.",
             "Mesh (section 5)", [&](const std::string& text) {
               try {
                 arguments.holes = parse_holes(text);
               } catch (const Error& error) {
                 throw Error(error.code(), std::string("--") + error.what());
               }
             });
  add_parsed(command, "--corners", "A,B,C,D",
             "Corners of the domains square and rectangle: ids of four points on one outer loop. Default: "
             "where the loop turns most [ours]. Of the preset default alone.",
             "Map (section 5)",
             [&](const std::string& text) { arguments.corners = parse_corners("--corners", text); });
  add_fields(command, arguments);
  add_parsed(command, "--preset", "NAME",
             fmt::format("Set of defaults that other flags change: {}. Default default.",
                         fmt::join(names_of<Preset>(), ", ")),
             "Run",
             [&](const std::string& text) { arguments.preset = parse_enum<Preset>("--preset", text); });
  add_common(command, arguments.common);
}

void add_mesh_method(CLI::App& command, MethodArguments& arguments) {
  add_path(command, "--reference", arguments.reference, "MESH",
           fmt::format("Measure the mesh against this one ({}): Hausdorff and mean distances both ways, and "
                       "agreement of edges where the vertices are the same; in the report and the summary",
                       names_of_formats(FormatUse::ReadFaces)));
  add_path(command, "--uv-picture", arguments.uv_picture, "OUT.png|svg",
           "Draw the map: its layout in the plane, and a checkerboard that it puts on the surface");
  add_parsed(
      command, "--texture-size", "N",
      "Bake the colours of the points into a picture of N pixels each way, laid out as the map: beside an "
      "OBJ "
      "as .png with .mtl, within a .glb. The map then lies in the square from 0 to 1. From 1 to 16384.",
      "Map (section 5)", [&](const std::string& text) {
        arguments.texture_size = static_cast<int>(parse_whole("--texture-size", text, 1, 16384));
      });
  add_parsed(
      command, "--texture-property", "NAME",
      "Bake this property of the points in place of their colours, from black at its least to white at its "
      "greatest value.",
      "Map (section 5)", [&](const std::string& text) { arguments.texture_property = text; });
  command
      .add_flag_callback(
          "--allow-partial",
          [] {
            fmt::print(stderr,
                       "rimline: --allow-partial is what is done without it; --strict does the reverse\n");
          },
          "Has no effect: parts that can not be meshed are left out and listed, unless --strict is given")
      ->group("Mesh (section 5)");
  command
      .add_flag(
          "--distortion", arguments.distortion,
          "Give PLY the properties angle_distortion (radians), area_distortion (ratio), stretch_l2 and "
          "stretch_linf (Sander et al. 2001), of points and of faces; the report has their summary always")
      ->group("Map (section 5)");
}

}  // namespace rimline::cli
