// SPDX-License-Identifier: GPL-3.0-or-later
// Charts of one surface: cut until the bounds hold, and joined again where that was not needed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "map/angle_error.h"
#include "map/conformal_scale.h"
#include "map/free_chart.h"
#include "map/open_mesh.h"
#include "rimline/map_by_charts.h"

namespace rimline {

struct Chart {
  OpenMesh open;
  std::optional<ChartMap> map;
  Index worst = 0;  // the vertex of the largest stretch
};

class Atlas {
 public:
  // `most_error`: above which lengths are not kept at the cost of angles; 0: they never are. `triangles`: of
  // the whole surface, of which the atlas may have a part.
  Atlas(const ChartOptions& options, const AngleError& most_error, std::int64_t triangles, const Run& run);

  // Maps the parts, which are discs with holes; where the choice is free, cuts until the bounds hold.
  void take(std::vector<OpenMesh> parts);

  // Cuts the largest chart in two until there are enough.
  void cut_to(std::size_t count);

  // Joins neighbouring charts, all parts of `whole`, where the bounds hold for both as one.
  void join(const OpenMesh& whole);

  // Appends the charts of another atlas.
  void append(Atlas&& other);

  std::vector<Chart>& charts() { return done_; }
  AngleError error() const;                // of all charts together
  bool failed() const { return failed_; }  // whether a chart has no map

 private:
  // The predicted stretch of a conformal map.
  struct Outlook {
    std::vector<double> log_scale, turning;
    Stretch stretch;
    Index worst = 0;
  };

  Outlook look(const OpenMesh& open);
  bool promises(const Stretch& stretch) const;
  bool is_near(const Stretch& stretch) const;
  std::optional<ChartMap> in_one(const OpenMesh& open) const;
  Chart whole(OpenMesh open);
  bool holds(const Chart& chart) const;
  bool is_bent(const Chart& chart) const;
  std::int64_t work_for(const OpenMesh& open) const;
  std::optional<Chart> mapped(OpenMesh open, const Outlook& outlook);
  std::optional<Chart> with_slits(const OpenMesh& open, Outlook outlook);
  std::optional<OpenMesh> without_cones(const OpenMesh& open);
  void treat(OpenMesh open);
  bool cut(const OpenMesh& open, Index vertex);

  const ChartOptions& options_;
  const Run& run_;
  AngleError most_error_;
  bool is_free_, failed_ = false;
  std::int64_t triangles_;
  std::int64_t looks_left_ = 0;  // vertices of charts that may yet be looked at
  std::int64_t work_left_ = 0;   // steps of descents times triangles
  std::vector<OpenMesh> open_;
  std::vector<Chart> done_;
};

}  // namespace rimline
