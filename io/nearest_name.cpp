// SPDX-License-Identifier: Apache-2.0
#include "io/nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace lume::io {
std::size_t edit_distance(std::string_view a, std::string_view b) {
  // row[j] is the distance of a's first i letters to b's first j (Wagner and Fischer 1974); two
  // rows back stands the one from which a swap comes (Damerau 1964).
  std::vector<std::size_t> before;
  std::vector<std::size_t> last;
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string relaxed_name(std::string_view name) {
  std::string relaxed(name);
  for (char& c : relaxed) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '-' || c == '_') c = ' ';
  }
  return relaxed;
}

std::string nearest_name(std::string_view wrong, const std::vector<std::string>& known) {
  const std::string target = relaxed_name(wrong);
  const std::size_t limit = std::max<std::size_t>(1, (target.size() + 1) / 3);
  std::string best;
  std::size_t best_distance = limit + 1;
  for (const std::string& name : known) {
    const std::string candidate = relaxed_name(name);
    std::size_t distance = best_distance;
    if (!target.empty() && candidate.find(target) != std::string::npos) {
      distance = 1;
    } else if (candidate.size() <= target.size() + limit &&
               target.size() <= candidate.size() + limit) {
      // Names come from files and can be long: what cannot be near is never compared.
      distance = edit_distance(target, candidate);
    }
    if (distance < best_distance) {
      best = name;
      best_distance = distance;
    }
  }
  return best;
}

std::string list_names(std::string_view wrong, const std::vector<std::string>& known) {
  std::string text;
  const std::string nearest = nearest_name(wrong, known);
  if (!nearest.empty()) text += "; did you mean " + nearest + "?";
  text += (text.empty() ? "; there are: " : " There are: ");
  for (const std::string& name : known) text += (&name == &known.front() ? "" : ", ") + name;
  return text;
}

}  // namespace lume::io
