// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/sampling_profile.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/model.h"
#include "base/parallel.h"
#include "local/anisotropy.h"

namespace rimline {
namespace {

constexpr std::size_t most_measured = 4096, most_anisotropy = 256;  // [speed]

template <class Value, class Measure>
PointSample<Value> measure_at(Points points, std::span<const Index> ids, std::size_t most, const Run& run,
                              const Measure& measure) {
  PointSample<Value> sample{most, {}};
  sample.items.resize(std::min(most, ids.size()));
  parallel_tasks(sample.items.size(), Stage::Survey, run, [&](std::size_t i) {
    sample.items[i] = {sample_key(points[ids[i]]), measure(ids[i])};
  });
  return sample;
}

std::vector<Distances> distances_of(const PointSample<SamplingMeasures>& sample) {
  std::vector<Distances> distances;
  for (const auto& [key, m] : sample.items) distances.push_back(m.distances);
  return distances;
}

double noise_of(const PointSample<SamplingMeasures>& sample) {
  std::vector<double> deviations;
  for (const auto& [key, m] : sample.items) deviations.push_back(m.deviation);
  return noise_level(std::move(deviations), variation_of_nearest(distances_of(sample)));
}

double anisotropy_of(const PointSample<double>& sample) {
  std::vector<double> values;
  for (const auto& [key, r] : sample.items) values.push_back(r);
  return mean_anisotropy(values);
}

// The ids of a part in the order in which they enter a sample.
std::vector<Index> chosen_of(Points points, std::span<const Index> part, const Run& run) {
  std::vector<Point> at;
  for (const Index id : part) at.push_back(points[id]);
  std::vector<Index> ids = choose_sample(at, most_measured, run);
  for (Index& id : ids) id = part[id];
  return ids;
}

PointSample<SamplingMeasures> take_measures(Points points, std::span<const Index> chosen,
                                            const Neighbours& neighbours, const std::vector<double>& spacing,
                                            const Run& run) {
  return measure_at<SamplingMeasures>(points, chosen, most_measured, run, [&](Index i) {
    return SamplingMeasures{quadric_deviation(points, neighbours, spacing, i),
                            measure_distances(points, neighbours, spacing, i)};
  });
}

PointSample<double> take_anisotropy(Points points, std::span<const Index> chosen,
                                    const Neighbours& neighbours, const std::vector<double>& spacing,
                                    const Run& run) {
  return measure_at<double>(points, chosen, most_anisotropy, run,
                            [&](Index i) { return anisotropy_at(points, neighbours, spacing, i); });
}

}  // namespace

SamplingSample& SamplingSample::operator+=(const SamplingSample& other) {
  measures += other.measures;
  anisotropy += other.anisotropy;
  return *this;
}

SamplingSample sample_sampling(Points points, std::span<const Index> part, const Neighbours& neighbours,
                               const std::vector<double>& spacing, const Run& run) {
  const std::vector<Index> chosen = chosen_of(points, part, run);
  return {take_measures(points, chosen, neighbours, spacing, run),
          take_anisotropy(points, chosen, neighbours, spacing, run), neighbours.k};
}

SamplingProfile profile_of(const SamplingSample& sample) {
  const double level = noise_of(sample.measures);
  const double anisotropy = level > model::noise_asked ? anisotropy_of(sample.anisotropy) : 0;
  SamplingProfile profile;
  // Along scan lines the nearest points are closer than the spacing, so that less noise matters.
  profile.noise_weight = noise_weight(level * std::exp(anisotropy / 2));
  profile.noise = {profile.noise_weight > 0 ? level : 0,
                   irregularity(distances_of(sample.measures), sample.k), anisotropy > 0};
  return profile;
}

SamplingProfile profile_sampling(Points points, const Neighbours& neighbours,
                                 const std::vector<double>& spacing, const Run& run) {
  const std::vector<Index> chosen = choose_sample(points, most_measured, run);
  SamplingSample sample{take_measures(points, chosen, neighbours, spacing, run), {}, neighbours.k};
  if (noise_of(sample.measures) > model::noise_asked)
    sample.anisotropy = take_anisotropy(points, chosen, neighbours, spacing, run);
  return profile_of(sample);
}

}  // namespace rimline
