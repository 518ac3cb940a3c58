// SPDX-License-Identifier: Apache-2.0
// What `lume compare --html` and `lume test --html` write: one page that holds its pictures, needs
// no network, and lets people look for themselves. One case fills the page; of many there is a
// list.
#pragma once

#include "io/compare/rgb_image.h"

#include <optional>
#include <string>
#include <vector>

namespace lume::io {

/// A picture as the page shows it.
struct PageImage {
  std::string label;  ///< under which it is known: a file's name
  RgbImage image;     ///< linear Rec.709
  /// Shown as sRGB codes, of 8 bits where those hold all that there is, and of 16 otherwise. A
  /// scene-linear image is shown with an exposure, and as floats.
  bool display_referred = false;
};

/// A row of the table of metrics. Texts, for the command prints the same ones.
struct PageFact {
  std::string name;   ///< "rmse"
  std::string value;  ///< "0.0123"
  std::string limit;  ///< "<= 0.01"; empty if there is none
  bool failed = false;
};

/// In the order in which they are listed: what needs a look comes first.
enum class PageVerdict { failed, refused, missing_reference, skipped, passed };

struct PageCase {
  std::string name;  ///< by which it is linked to (#case=name); should be the only one of that name
  PageVerdict verdict = PageVerdict::passed;
  std::string message;  ///< one line: why
  std::vector<PageFact> facts;
  std::optional<PageImage> actual;
  std::optional<PageImage> expected;
  /// FLIP of every pixel, in [0, 1], of the size of `actual`; may be empty.
  std::vector<float> flip_map;
  std::string accept_command;     ///< that makes the actual image the expected one; may be empty
  std::optional<double> seconds;  ///< that the case took
  std::string history;  ///< "first failed 2026-11-02, 3 of the last 20 runs"; may be empty
};

struct ReportPage {
  std::string title;    ///< "lume test"
  std::string command;  ///< that made the page, as typed
  std::string summary;  ///< one line: "2 of 30 failed"
  std::vector<PageCase> cases;
};

/// The page as UTF-8, the same bytes for the same report. Texts may be any bytes: what is no UTF-8
/// becomes U+FFFD, and nothing of them is taken for markup. Scene-linear values are kept as half
/// floats (small images as floats, where halfs do not hold their values). Pictures for which a page
/// would get too large are reduced to the means of squares of pixels, which the page then says:
/// those of more than 4096 x 2304 pixels, and in a report of many cases those that are wider or
/// higher than 2048 pixels, or come after the first 12 million pixels. Throws nothing but
/// bad_alloc.
[[nodiscard]] std::string to_html(const ReportPage& report);

}  // namespace lume::io
