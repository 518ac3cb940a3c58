// SPDX-License-Identifier: Apache-2.0
#include "shading/distribution.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lume::shading {
namespace {

constexpr float k_below_one = 1.0f - 0.5f * std::numeric_limits<float>::epsilon();

/// A weight that is negative or not finite counts as 0.
double usable(float weight) {
  return weight > 0.0f && std::isfinite(weight) ? static_cast<double>(weight) : 0.0;
}

std::size_t cell_of(float position, std::size_t size) {
  const float scaled = std::max(position, 0.0f) * static_cast<float>(size);
  return std::min(static_cast<std::size_t>(scaled), size - 1);
}

/// (cell + fraction) / size, moved by the last bit where rounding would carry it into a neighbour:
/// the density looked up at a sample's position has to be the one it was drawn with.
float position_in(std::size_t cell, float fraction, std::size_t size) {
  float position = (static_cast<float>(cell) + fraction) / static_cast<float>(size);
  position = std::min(position, k_below_one);
  while (cell_of(position, size) > cell) position = std::nextafter(position, 0.0f);
  while (cell_of(position, size) < cell) position = std::nextafter(position, 1.0f);
  return position;
}

std::vector<double> row_totals(const std::vector<Distribution1D>& rows) {
  std::vector<double> totals;
  totals.reserve(rows.size());
  for (const Distribution1D& row : rows) totals.push_back(row.total());
  return totals;
}

/// Scaled so that rows brighter than a float can say do not become infinite.
std::vector<float> row_weights(const std::vector<Distribution1D>& rows) {
  const std::vector<double> totals = row_totals(rows);
  const double largest = *std::max_element(totals.begin(), totals.end());
  std::vector<float> weights;
  weights.reserve(rows.size());
  for (const double total : totals) {
    weights.push_back(largest > 0.0 ? static_cast<float>(total / largest) : 0.0f);
  }
  return weights;
}

std::vector<Distribution1D> make_rows(int width, int height, std::span<const float> weights) {
  std::vector<Distribution1D> rows;
  rows.reserve(static_cast<std::size_t>(height));
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
    rows.emplace_back(
        weights.subspan(y * static_cast<std::size_t>(width), static_cast<std::size_t>(width)));
  }
  return rows;
}

}  // namespace

Distribution1D::Distribution1D(std::span<const float> weights) {
  for (const float weight : weights) total_ += usable(weight);

  cumulative_.reserve(weights.size() + 1);
  cumulative_.push_back(0.0f);
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    // The same additions as above in the same order: the last sum is total_ exactly, so that cells
    // of weight 0 at the end start at 1 and are out of reach.
    sum += usable(weights[i]);
    const double share = total_ > 0.0
                             ? sum / total_
                             : static_cast<double>(i + 1) / static_cast<double>(weights.size());
    cumulative_.push_back(static_cast<float>(share));
  }

  guide_.reserve(weights.size());
  std::uint32_t cell = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const float r = static_cast<float>(i) / static_cast<float>(weights.size());
    while (cumulative_[cell + 1] <= r) ++cell;
    guide_.push_back(cell);
  }
}

Distribution1D::Sample Distribution1D::sample(float random) const {
  const float r = random >= 0.0f ? std::min(random, k_below_one) : 0.0f;
  // The first bound above r closes the cell; since its lower bound is <= r, it is not empty.
  std::size_t cell = guide_[cell_of(r, size())];
  while (cumulative_[cell] > r) --cell;  // the guide rounds
  while (cumulative_[cell + 1] <= r) ++cell;
  const float width = cumulative_[cell + 1] - cumulative_[cell];
  return {cell, position_in(cell, (r - cumulative_[cell]) / width, size()), width};
}

float Distribution1D::probability(std::size_t cell) const {
  return cumulative_[cell + 1] - cumulative_[cell];
}

Distribution2D::Distribution2D(int width, int height, std::span<const float> weights)
    : rows_(make_rows(width, height, weights)), row_choice_(row_weights(rows_)) {}

Distribution2D::Sample Distribution2D::sample(geometry::Vec2 random) const {
  const Distribution1D::Sample row = row_choice_.sample(random.y);
  const Distribution1D::Sample column = rows_[row.cell].sample(random.x);
  const float pdf = column.probability * static_cast<float>(rows_[row.cell].size()) *
                    row.probability * static_cast<float>(rows_.size());
  return {{column.position, row.position}, pdf};
}

float Distribution2D::pdf(geometry::Vec2 position) const {
  const std::size_t y = cell_of(position.y, rows_.size());
  const Distribution1D& row = rows_[y];
  const std::size_t x = cell_of(position.x, row.size());
  return row.probability(x) * static_cast<float>(row.size()) * row_choice_.probability(y) *
         static_cast<float>(rows_.size());
}

}  // namespace lume::shading
