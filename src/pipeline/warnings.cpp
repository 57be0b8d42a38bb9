// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/domain_traits.h"

namespace rimline::pipeline {
namespace {

// "component 3 of 1,200 points is ..." or "7 of 450 components are ..., the largest is component 3 of 1,200
// points"; "" where there is none.
template <class Patch, class IsIt>
std::string tell(const std::vector<Patch>& patches, const IsIt& is_it, const std::string& one,
                 const std::string& many) {
  std::size_t count = 0, largest = 0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (!is_it(patches[p])) continue;
    if (count++ == 0 || patches[p].points > patches[largest].points) largest = p;
  }
  if (count == 0) return "";
  const std::string which = fmt::format("component {} of {} points", largest, patches[largest].points);
  if (count == 1) return which + " " + one;
  return fmt::format("{} of {} components {}; the largest is {}", count, patches.size(), many, which);
}

std::string tell_of_suspects(const std::vector<PatchReport>& patches) {
  double most = 0;
  for (const PatchReport& patch : patches) most = std::max(most, patch.suspect ? patch.bad_share : 0);
  const std::string why = fmt::format(
      ": up to {:.1f} % of the inner edges are longer than 3 spacings or folded beyond 120 degrees",
      100 * most);
  return tell(
      patches, [](const PatchReport& p) { return p.suspect; }, "is suspect" + why, "are suspect" + why);
}

std::string tell_of_failures(const std::vector<PatchReport>& patches) {
  const auto failed = std::ranges::find_if(patches, [](const PatchReport& p) { return !p.failure.empty(); });
  if (failed == patches.end()) return "";
  return tell(
      patches, [](const PatchReport& p) { return !p.failure.empty(); }, "was not meshed: " + failed->failure,
      "were not meshed (" + failed->failure + ")");
}

std::string tell_of_repairs(const std::vector<PatchReport>& patches) {
  std::size_t repairs = 0;
  for (const PatchReport& patch : patches) repairs += patch.repairs.size();
  if (repairs == 0) return "";
  return fmt::format(
      "{} short {} taken for noise and mended; the report has the places, --handles keep leaves "
      "them",
      repairs, repairs == 1 ? "handle was" : "handles were");
}

}  // namespace

std::vector<std::string> warn_of_components(const std::vector<PatchReport>& patches) {
  std::vector<std::string> told{tell_of_suspects(patches), tell_of_failures(patches),
                                tell_of_repairs(patches)};
  std::erase(told, "");
  return told;
}

std::vector<std::string> warn_of_doubtful(const std::vector<DoubtfulGap>& gaps,
                                          const BoundaryLoopOptions& options) {
  if (gaps.empty()) return {};
  const DoubtfulGap& first = gaps.front();
  const std::string which =
      gaps.size() == 1 ? "a gap" : fmt::format("{} gaps may be boundaries, the likeliest", gaps.size());
  std::string remedy;
  if (first.probability < options.min_probability)
    remedy += fmt::format(" --min-probability {:.2f}", std::floor(100 * first.probability) / 100);
  if (first.points < static_cast<std::size_t>(options.min_loop))
    remedy += fmt::format(" --min-loop {}", first.points);
  return {fmt::format(
      "{} of {} points near {:.6g} {:.6g} {:.6g} is a boundary with probability {:.2f};{} returns "
      "it as a loop",
      which, first.points, first.place.x, first.place.y, first.place.z, first.probability, remedy)};
}

std::vector<std::string> warn_of_maps(const std::vector<ComponentSummary>& components, Domain wanted) {
  if (!has_map(wanted)) return {};
  const auto is_mapped = [](const ComponentSummary& c) { return has_map(c.map); };
  const auto none = [&](const ComponentSummary& c) { return c.triangles > 0 && !is_mapped(c); };
  const auto free = [&](const ComponentSummary& c) {
    return traits(c.map).released && !traits(wanted).released;
  };
  const auto disc = [&](const ComponentSummary& c) { return is_mapped(c) && c.map != wanted && !free(c); };
  const std::string no_map = " no map: every one that was made turns triangles over";
  const std::string of_charts =
      " a free map, of one chart or several: not a disc with holes, or squeezed too far in " +
      std::string("the ") + name(wanted);
  const std::string of_disc =
      " the disc's map, at the area of the surface: no free map without turned triangles was found";
  std::vector<std::string> told{tell(components, none, "has" + no_map, "have" + no_map),
                                tell(components, free, "has" + of_charts, "have" + of_charts),
                                tell(components, disc, "has" + of_disc, "have" + of_disc)};
  std::erase(told, "");
  return told;
}

std::vector<std::string> warn_of_long_edges(double longest_over_median) {
  if (!(longest_over_median > far_longer)) return {};
  return {fmt::format("an edge is {:.1f} median spacings long; more than {} is far for this sample",
                      longest_over_median, far_longer)};
}

}  // namespace rimline::pipeline
