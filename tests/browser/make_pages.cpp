// SPDX-License-Identifier: Apache-2.0
// Writes the pages that the browser test opens: one.html, display.html and many.html, into the
// folder that is the only argument. What their pixels are, viewer_page_test.py knows.
#include "io/report/viewer_page.h"
#include "shading/color.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

using lume::io::PageCase;
using lume::io::PageImage;
using lume::io::PageVerdict;
using lume::io::ReportPage;
using lume::io::RgbImage;
using lume::shading::Color;

constexpr int k_width = 96;
constexpr int k_height = 72;
constexpr int k_worst_x = 70;
constexpr int k_worst_y = 50;

template <class Value>
RgbImage make_image(int width, int height, const Value& value) {
  RgbImage image{width, height, {}};
  image.pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.pixels.push_back(value(x, y));
  }
  return image;
}

/// Ramps of 128ths, which half floats hold; blue tells the pictures apart.
RgbImage ramps(float blue, bool with_worst_pixel) {
  return make_image(k_width, k_height, [&](int x, int y) {
    const bool worst = with_worst_pixel && x == k_worst_x && y == k_worst_y;
    return Color(static_cast<float>(x) / 128.0f, static_cast<float>(y) / 128.0f,
                 worst ? 8.0f : blue);
  });
}

RgbImage codes(int blue) {
  return make_image(k_width, k_height, [&](int x, int y) {
    const auto linear = [](int code) {
      return lume::shading::srgb_to_linear(static_cast<float>(code) / 255.0f);
    };
    return Color(linear(2 * x), linear(3 * y), linear(blue));
  });
}

PageCase linear_case(std::string name, PageVerdict verdict) {
  PageCase made;
  made.name = std::move(name);
  made.verdict = verdict;
  made.facts = {{"rmse", "0.14434", verdict == PageVerdict::failed ? "<= 0.01" : "<= 0.2",
                 verdict == PageVerdict::failed},
                {"flip", "0.1843", "", false},
                {"psnr", "16.8 dB", ">= 10 dB", false}};
  made.actual = PageImage{"out/actual.exr", ramps(0.25f, true), false};
  made.expected = PageImage{"tests/images/references/expected.exr", ramps(0.5f, false), false};
  made.flip_map.assign(made.actual->image.pixels.size(), 0.25f);
  made.flip_map[k_worst_y * k_width + k_worst_x] = 1.0f;
  return made;
}

ReportPage one_page() {
  PageCase only =
      linear_case("out/actual.exr and tests/images/references/expected.exr", PageVerdict::failed);
  only.message = "rmse is 0.14434, more than 0.01";
  only.accept_command = "cp out/actual.exr tests/images/references/expected.exr";
  return {"lume compare",
          "lume compare out/actual.exr expected.exr --html one.html",
          "1 of 3 limits exceeded",
          {std::move(only)}};
}

ReportPage display_page() {
  PageCase only;
  only.name = "a.png and b.png";
  only.actual = PageImage{"a.png", codes(128), true};
  only.expected = PageImage{"b.png", codes(132), true};
  return {"lume compare", "lume compare a.png b.png", "", {std::move(only)}};
}

/// Names are what people may come to write.
ReportPage many_page() {
  ReportPage page{"lume test",
                  "lume test tests/images --html report.html",
                  "3 of 31 cases did not pass; 4.2 s",
                  {}};
  for (int i = 0; i < 26; ++i) {
    PageCase made = linear_case("spheres/case-" + std::to_string(i), PageVerdict::passed);
    made.seconds = 0.1 * i;
    page.cases.push_back(std::move(made));
  }
  PageCase failed = linear_case("</script><script>injected = 1</script>", PageVerdict::failed);
  failed.message = "<b>rmse</b> & more: 0.14434, more than 0.01";
  failed.history = "first failed 2026-11-02, 3 of the last 20 runs";
  page.cases.push_back(std::move(failed));
  PageCase missing = linear_case("glass/no reference yet", PageVerdict::missing_reference);
  missing.expected.reset();
  missing.flip_map.clear();
  missing.facts.clear();
  missing.message = "tests/images/references/glass.exr is not there";
  missing.accept_command =
      "lume test tests/images --filter 'glass/no reference yet' --update missing";
  page.cases.push_back(std::move(missing));
  PageCase refused = linear_case("sizes/other", PageVerdict::refused);
  refused.expected->image = make_image(120, 60, [](int, int) { return Color(0.5f); });
  refused.flip_map.clear();
  refused.message = "the images are 96 x 72 and 120 x 60 pixels";
  page.cases.push_back(std::move(refused));
  PageCase skipped;
  skipped.name = "museum/night";
  skipped.verdict = PageVerdict::skipped;
  skipped.message = "LUME_TEST_DATA is not set";
  page.cases.push_back(std::move(skipped));
  PageCase not_finite = linear_case("non-finite/100% nan + inf", PageVerdict::refused);
  not_finite.actual->image.pixels[0] = Color(std::nanf(""), 0.0f, INFINITY);
  not_finite.message = "actual: 1 pixel is not finite";
  page.cases.push_back(std::move(not_finite));
  return page;
}

void write(const std::filesystem::path& path, const ReportPage& page) {
  std::ofstream file(path, std::ios::binary);
  file << to_html(page);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  write(folder / "one.html", one_page());
  write(folder / "display.html", display_page());
  write(folder / "many.html", many_page());
  return 0;
}
