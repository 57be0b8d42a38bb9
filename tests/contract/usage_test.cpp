// SPDX-License-Identifier: GPL-3.0-or-later
// Status 1: what is refused before any work.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <concepts>

#include "rimline/options.h"
#include "rimline/sample.h"
#include "rimline/version.h"
#include "tool.h"

using namespace rimline::test;

namespace {

const std::vector<std::string> subcommands = {"boundary", "reconstruct", "parameterize", "info", "sample"};
const std::vector<std::string> method_subcommands = {"boundary", "reconstruct", "parameterize"};

std::string dashed(std::string field) {
  for (char& c : field) c = c == '_' ? '-' : c;
  return "--" + field;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// One line that begins as every message of the tool does.
bool one_sentence(const std::string& text) {
  return text.starts_with("rimline: ") && text.find('\n') == text.size() - 1;
}

}  // namespace

TEST_CASE("the help of the tool and of every subcommand begins with an example") {
  const Finished whole = rimline::test::rimline({"--help"});
  CHECK(whole.status == 0);
  CHECK(whole.out.starts_with("Example: rimline reconstruct "));
  for (const auto& name : subcommands) {
    CAPTURE(name);
    CHECK(contains(whole.out, "\n  " + name + " "));
    const Finished help = rimline::test::rimline({name, "--help"});
    CHECK(help.status == 0);
    CHECK(help.err.empty());
    CHECK(help.out.starts_with("Example: rimline " + name + " "));
    for (const char* flag : {"--seed", "--threads", "--quiet", "--help", "--version"}) {
      CAPTURE(flag);
      CHECK(contains(help.out, flag));
    }
    const bool has_method = std::ranges::find(method_subcommands, name) != std::end(method_subcommands);
    CHECK(contains(help.out, "--preset") == has_method);
  }
}

TEST_CASE("info and sample, which run no method, refuse a preset") {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"info", "no.ply"}, {"sample", "pipe", "-n", "50", "-o", "no.ply"}}) {
    std::vector<std::string> with_preset = arguments;
    with_preset.insert(with_preset.end(), {"--preset", "paper"});
    const Finished run = rimline::test::rimline(with_preset);
    CHECK(run.status == 1);
    CHECK(contains(run.err, "--preset"));
  }
}

TEST_CASE("every field of the options is a flag whose help gives its default") {
  const rimline::Options options = rimline::preset_options(rimline::Preset::Default);
  for (const auto& name : method_subcommands) {
    const std::string help = rimline::test::rimline({name, "--help"}).out;
    rimline::visit_fields(options, [&](const auto& field) {
      CAPTURE(field.name);
      const std::size_t at = help.find("\n  " + dashed(field.name) + " ");
      REQUIRE(at != std::string::npos);
      const std::size_t end = std::min(help.find("\n  --", at + 1), help.size());
      CHECK(contains(help.substr(at, end - at), "Default"));
    });
  }
}

TEST_CASE(
    "an option that the preset does not use is refused, whatever its value, and its presets are named") {
  for (const rimline::Preset preset : {rimline::Preset::Default, rimline::Preset::Paper}) {
    const rimline::Options options = rimline::preset_options(preset);
    rimline::visit_fields(options, [&](const auto& field) {
      if (counts(field.used_by, options)) return;
      std::vector<std::string> arguments = {"boundary", "no.ply", "--preset", name(preset),
                                            dashed(field.name)};
      if constexpr (std::is_enum_v<std::remove_cvref_t<decltype(field.value)>>) {
        arguments.emplace_back(name(field.value));
      } else if constexpr (!std::same_as<decltype(field.value), const bool&>) {
        arguments.push_back(fmt::format("{}", field.value));
      }
      const Finished refused = rimline::test::rimline(arguments);
      CAPTURE(refused.err);
      CHECK(refused.status == 1);
      CHECK(one_sentence(refused.err));
      CHECK(contains(refused.err, dashed(field.name) + " is " + where_used(field.used_by)));
    });
  }
}

TEST_CASE("flags that are no field and do not count are refused as well") {
  using Arguments = std::vector<std::string>;
  const std::vector<std::pair<Arguments, std::string>> cases = {
      {{"--preset", "paper", "--holes", "keep"}, "of the preset default alone"},
      {{"--preset", "paper", "--corners", "1,2,3,4"}, "of the preset default alone"},
      {{"--history", "h.json"}, "of the presets paper and paper-log alone"},
      {{"--preset", "paper-log", "--score-cap", "0.1"}, "the score form log does not use it"},
      {{"--preset", "paper", "--use-loops", "l.json", "--history", "h.json"}, "--use-loops gives the loops"},
      {{"--preset", "paper", "--use-loops", "l.json", "--path-k", "10"}, "--use-loops gives the loops"},
  };
  for (const auto& [more, sentence] : cases) {
    Arguments arguments = {"boundary", "no.ply"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Finished refused = rimline::test::rimline(arguments);
    CAPTURE(refused.err);
    CHECK(refused.status == 1);
    CHECK(one_sentence(refused.err));
    CHECK(contains(refused.err, sentence));
  }
}

TEST_CASE("the help says which presets a field belongs to") {
  const rimline::Options options;
  const std::string help = rimline::test::rimline({"boundary", "--help"}).out;
  rimline::visit_fields(options, [&](const auto& field) {
    CAPTURE(field.name);
    const std::size_t at = help.find("\n  " + dashed(field.name) + " ");
    std::string text = help.substr(at, help.find("\n  --", at + 1) - at);
    std::string line;  // wrapping undone
    for (const char c : text) {
      if (c != '\n' && (c != ' ' || line.empty() || line.back() != ' ')) line += c;
      if (c == '\n' && line.back() != ' ') line += ' ';
    }
    std::string where = where_used(field.used_by);
    if (!where.empty()) CHECK(contains(line, where.substr(3)));
  });
}

TEST_CASE("the help of sample lists every shape and every sampling") {
  const std::string help = rimline::test::rimline({"sample", "--help"}).out;
  for (const auto shape : rimline::all_shapes()) CHECK(contains(help, name(shape)));
  for (const auto sampling : rimline::all_samplings()) CHECK(contains(help, name(sampling)));
}

TEST_CASE("the tool and every subcommand give the version") {
  const std::string line = std::string("rimline ") + rimline::version + "\n";
  CHECK(rimline::test::rimline({"--version"}).out == line);
  for (const auto& name : subcommands) {
    const Finished version = rimline::test::rimline({name, "--version"});
    CHECK(version.status == 0);
    CHECK(version.out == line);
  }
}

TEST_CASE("a value out of range is refused in one sentence with flag, value, range and where to look") {
  const rimline::Options options;
  for (const auto& name : method_subcommands) {
    rimline::visit_fields(options, [&](const auto& field) {
      if constexpr (std::same_as<decltype(field.value), const bool&>) return;  // takes no value
      const Finished refused =
          rimline::test::rimline({name, "no.ply", "-o", "out.ply", dashed(field.name), "-7"});
      CAPTURE(refused.err);
      CHECK(refused.status == 1);
      CHECK(one_sentence(refused.err));
      CHECK(contains(refused.err, dashed(field.name) + " "));
      CHECK(contains(refused.err, "'-7'"));
      CHECK(contains(refused.err, "rimline " + name + " --help"));
      if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(field.value)>>) {
        CHECK(contains(refused.err, fmt::format("from {} to {}", field.least, field.most)));
      }
    });
  }
}

TEST_CASE("bad usage ends with status 1, one sentence and nothing on standard output") {
  using Arguments = std::vector<std::string>;
  const std::vector<std::pair<Arguments, std::string>> cases = {
      {{}, "subcommand"},
      {{"frobnicate"}, "'frobnicate'"},
      {{"--frobnicate"}, "'--frobnicate'"},
      {{"boundary", "a.ply", "--frobnicate"}, "'--frobnicate'"},
      {{"boundary", "a.ply", "b.ply"}, "'b.ply'"},
      {{"boundary"}, "IN"},
      {{"reconstruct", "a.ply"}, "--output"},
      {{"boundary", "a.ply", "--k"}, "--k"},
      {{"boundary", "a.ply", "--k", "many"}, "'many'"},
      {{"boundary", "a.ply", "--k", "40.5"}, "'40.5'"},
      {{"boundary", "a.ply", "--significance", "nan"}, "'nan'"},
      {{"boundary", "a.ply", "--seed", "-1"}, "'-1'"},
      {{"boundary", "a.ply", "--threads", "-1"}, "'-1'"},
      {{"boundary", "a.ply", "--preset", "best"}, "default, paper, paper-log"},
      {{"reconstruct", "a.ply", "-o", "m.ply", "--up", "0,0"}, "'0,0'"},
      {{"reconstruct", "a.ply", "-o", "m.ply", "--up", "0,0,0"}, "'0,0,0'"},
      {{"reconstruct", "a.ply", "-o", ""}, "--output wants the name of a file"},
      {{"reconstruct", "a.ply", "-o", "m.ply", "--loops", ""}, "--loops wants"},
      {{"reconstruct", "a.ply", "-o", "m.ply", "--report="}, "--report"},
      {{"reconstruct", "a.ply", "-o", "m.ply", "--use-loops", ""}, "--use-loops wants"},
      {{"boundary", "a.ply", "--picture", ""}, "--picture wants"},
      {{"boundary", ""}, "IN wants"},
      {{"info", ""}, "IN wants"},
      {{"sample", "flat-disc", "-n", "100", "-o", "s.ply", "--truth", ""}, "--truth wants"},
      {{"reconstruct", "a.ply", "-o", "mesh.docx"}, "mesh.docx"},
      {{"reconstruct", "a.ply", "-o", "mesh"}, "mesh"},
      {{"boundary", "a.ply", "--loops", "loops.txt"}, "loops.txt"},
      {{"boundary", "a.ply", "--report", "report.txt"}, "report.txt"},
      {{"boundary", "a.ply", "--picture", "p.gif"}, "p.gif"},
      {{"boundary", "a.ply", "--picture", "-"}, "--picture"},
      {{"boundary", "a.ply", "--picture", "p.png", "--panels", "points,mash"}, "'mash'"},
      {{"boundary", "a.ply", "--loops", "x.json", "--report", "./x.json"}, "--report"},
      {{"boundary", "a.ply", "--loops", "-", "--report", "-"}, "--report"},
      {{"boundary", "-", "--use-loops", "-"}, "standard input"},
      {{"sample", "cube", "-n", "10", "-o", "s.ply"}, "'cube'"},
      {{"sample", "flat-disc", "-o", "s.ply"}, "-n"},
      {{"sample", "flat-disc", "-n", "0", "-o", "s.ply"}, "'0'"},
      {{"sample", "flat-disc", "-n", "100", "-o", "s.ply", "--noise", "-1"}, "'-1'"},
      {{"sample", "flat-disc", "-n", "100", "-o", "s.ply", "--sampling", "even"}, "'even'"},
      {{"sample", "flat-disc", "-n", "100", "-o", "s.xyz"}, "s.xyz"},
  };
  for (const auto& [arguments, named] : cases) {
    const Finished refused = rimline::test::rimline(arguments);
    CAPTURE(named);
    CAPTURE(refused.err);
    CHECK(refused.status == 1);
    CHECK(refused.out.empty());
    CHECK(one_sentence(refused.err));
    CHECK(contains(refused.err, named));
    CHECK(contains(refused.err, "--help"));
  }
}

TEST_CASE("a device or pipe needs no ending: it gets PLY, or JSON") {
  const Folder folder;
  write_file(folder / "grid.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
  const Finished loops = rimline::test::rimline(
      {"boundary", folder / "grid.xyz", "-o", "/dev/null", "--loops", "/dev/stdout", "--quiet"});
  CHECK(loops.status == 0);
  CHECK(loops.out.starts_with("{\"schema\": 1"));
  const Finished sample = rimline::test::rimline({"sample", "flat-disc", "-n", "50", "-o", "/dev/stdout"});
  CHECK(sample.status == 0);
  CHECK(sample.out.starts_with("ply\n"));
  for (const char* flag : {"-o", "--loops", "--report"}) {
    CAPTURE(flag);
    CHECK(rimline::test::rimline({"boundary", folder / "grid.xyz", flag, "/dev/full"}).status == 4);
  }
  CHECK(folder.names() == std::vector<std::string>{"grid.xyz"});
}

TEST_CASE("a mesh that could not be written is refused before the input is looked at") {
  CHECK(rimline::test::rimline({"reconstruct", "/no/such.ply", "-o", "mesh.docx"}).status == 1);
  CHECK(rimline::test::rimline({"reconstruct", "/no/such.ply", "-o", "/no/such/mesh.ply"}).status == 4);
}
