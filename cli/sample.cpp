// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/sample.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "parse.h"
#include "rimline/io.h"
#include "session.h"
#include "standard_streams.h"
#include "subcommands.h"

namespace rimline::cli {
namespace {

constexpr std::int64_t most_points = 100'000'000;
constexpr double most_noise = 100;

struct SampleArguments {
  Common common;
  SampleOptions options;
  std::string output, truth;
};

template <class Enum>
std::vector<std::string> names_in(const std::vector<Enum>& all) {
  std::vector<std::string> names;
  for (const Enum value : all) names.emplace_back(name(value));
  return names;
}

void run_sample(const SampleArguments& arguments) {
  const std::vector<Output> outputs = {{"--output", arguments.output, {"ply"}},
                                       {"--truth", arguments.truth, {"json"}}};
  check_outputs(outputs);
  Session session(arguments.common);
  Sample result = sample(arguments.options, session.run());
  Cloud cloud;
  cloud.points = std::move(result.points);
  set_column(cloud, make_column("boundary", result.boundary));
  write_cloud(arguments.output, cloud, session.run());
  if (!arguments.truth.empty()) write_text(arguments.truth, loops_to_json(result.loops, cloud.points.size()));
  session.bar().erase();
  if (arguments.common.quiet) return;
  print_notice(fmt::format("{} points of {}, {} loops, in {}\n", cloud.points.size(),
                           name(arguments.options.shape), result.loops.size(), list_files(outputs)),
               any_standard(outputs));
}

void add_sample_options(CLI::App& command, SampleArguments& arguments) {
  const auto shapes = names_in(all_shapes());
  const auto samplings = names_in(all_samplings());
  SampleOptions& options = arguments.options;
  add_parsed(command, "shape", "SHAPE", fmt::format("One of {}", fmt::join(shapes, ", ")), "Sample",
             [&options, shapes](const std::string& text) {
               options.shape = all_shapes()[parse_choice("SHAPE", text, shapes)];
             })
      ->required();
  add_parsed(command, "-n", "N",
             fmt::format("Points wanted; the result has about as many. From 1 to {}", most_points), "Sample",
             [&options](const std::string& text) {
               options.n = static_cast<std::size_t>(parse_whole("-n", text, 1, most_points));
             })
      ->required();
  add_parsed(command, "--sampling", "NAME",
             fmt::format("One of {}. Default {}.", fmt::join(samplings, ", "), name(options.sampling)),
             "Sample", [&options, samplings](const std::string& text) {
               options.sampling = all_samplings()[parse_choice("--sampling", text, samplings)];
             });
  add_parsed(command, "--noise", "X",
             fmt::format("Standard deviation of Gaussian noise, in units of the local mean nearest-neighbour "
                         "distance. From 0 to {}. Default {}.",
                         most_noise, options.noise),
             "Sample", [&options](const std::string& text) {
               options.noise = parse_number("--noise", text, 0, most_noise);
             });
}

}  // namespace

void add_sample(CLI::App& tool) {
  auto arguments = std::make_shared<SampleArguments>();
  CLI::App& command =
      add_subcommand(tool, "sample", "Take points from an analytic surface whose boundary is known exactly.",
                     "rimline sample hemisphere-cap -n 10000 -o cap.ply --truth truth.json");
  add_sample_options(command, *arguments);
  add_output(command, arguments->output, "OUT.ply",
             "The points, with boundary (1 on a true loop); - for standard output", true);
  add_path(command, "--truth", arguments->truth, "LOOPS.json",
           "Write the true loops (JSON, schema 1); - for standard output");
  add_common(command, arguments->common);
  command.callback([arguments] { run_sample(*arguments); });
}

}  // namespace rimline::cli
