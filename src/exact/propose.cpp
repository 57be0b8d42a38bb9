// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/propose.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace rimline::exact {
namespace {

struct Proposal {
  Triangle triangle;
  int votes;
  double size;  // circumradius over spacing

  auto rank() const { return std::tuple(-votes, size, triangle); }
};

bool has_triangle(const Star& star, Index a, Index b) {
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Index x = star[i], y = star[i + 1 < star.size() ? i + 1 : 0];
    if ((x == a && y == b) || (x == b && y == a)) return true;
  }
  return false;
}

class Proposer {
 public:
  Proposer(Complex& complex, const std::vector<double>& spacing, double largest)
      : complex_(complex), spacing_(spacing), largest_(largest) {}

  double size(const Triangle& t) const {
    const Points p = complex_.points();
    const double h = std::max({spacing_[t[0]], spacing_[t[1]], spacing_[t[2]]});
    return circumradius(p[t[0]], p[t[1]], p[t[2]]) / h;
  }

  // Adds those with three votes and returns the others.
  std::vector<Proposal> take_agreed(const std::vector<Star>& stars) {
    std::vector<Proposal> rest;
    for (Index v = 0; v < static_cast<Index>(stars.size()); ++v) {
      const Star& star = stars[v];
      for (std::size_t i = 0; i < star.size(); ++i) {
        const Index a = star[i], b = star[i + 1 < star.size() ? i + 1 : 0];
        if (a == none || b == none) continue;
        const bool by_a = has_triangle(stars[a], b, v), by_b = has_triangle(stars[b], v, a);
        if ((by_a && a < v) || (by_b && b < v)) continue;  // met before
        const Proposal proposal{{v, a, b}, 1 + by_a + by_b, size({v, a, b})};
        if (proposal.size > largest_) continue;
        if (proposal.votes == 3) {
          complex_.add(proposal.triangle);
        } else {
          rest.push_back(proposal);
        }
      }
    }
    return rest;
  }

  void take_fitting(std::vector<Proposal> rest) {
    std::sort(rest.begin(), rest.end(), [](const auto& x, const auto& y) { return x.rank() < y.rank(); });
    for (const Proposal& p : rest) {
      if (complex_.can_add(p.triangle)) complex_.add(p.triangle);
    }
  }

  void fill_notches() {
    const Index known = complex_.size();
    for (Index t = 0; t < known; ++t) offer_at(t);
    while (!queue_.empty()) {
      const Triangle triangle = queue_.top().second;
      queue_.pop();
      if (!complex_.can_add(triangle)) continue;
      complex_.add(triangle);
      offer_at(complex_.size() - 1);
    }
  }

 private:
  using Notch = std::pair<double, Triangle>;  // size first

  // Offers the notches at both ends of each rim edge of a triangle.
  void offer_at(Index t) {
    const Triangle triangle = complex_.triangle(t);
    for (int i = 0; i < 3; ++i) {
      const Index a = triangle[i], b = triangle[(i + 1) % 3];
      if (complex_.across(t, i) != none) continue;
      offer(t, a, b);
      offer(t, b, a);
    }
  }
  // The notch at b between rim edge ab and the next rim edge around b.
  void offer(Index t, Index a, Index b) {
    Index at = a;
    for (Index next = t; next != none; next = complex_.across(next, b, at)) {
      at = complex_.apex(next, b, at);
      t = next;
    }
    if (at == a) return;
    const Triangle triangle{b, std::min(a, at), std::max(a, at)};
    const double s = size(triangle);
    if (s <= largest_) queue_.push({s, triangle});
  }

  Complex& complex_;
  const std::vector<double>& spacing_;
  double largest_;
  std::priority_queue<Notch, std::vector<Notch>, std::greater<>> queue_;
};

}  // namespace

Complex propose_surface(Points points, const std::vector<Frame>& frames, const std::vector<Star>& stars,
                        const std::vector<double>& spacing, double largest, const Run& run) {
  Complex complex(points, frames);
  Proposer proposer(complex, spacing, largest);
  auto rest = proposer.take_agreed(stars);
  run.check_cancel();
  proposer.take_fitting(std::move(rest));
  run.check_cancel();
  proposer.fill_notches();
  return complex;
}

void fill_notches(Complex& complex, const std::vector<double>& spacing, double largest) {
  Proposer(complex, spacing, largest).fill_notches();
}

}  // namespace rimline::exact
