// A fixture for pages of desmo view: what C++ wrote into them, and what their scripts read.
#pragma once

#include <cstddef>
#include <string>

#include "tests/cli/program.h"

namespace desmo {

/// The largest size of a page [bytes].
inline constexpr std::size_t max_page = 2'000'000;

/// A fixture whose tests are skipped where the program was built without its page.
class View : public Cli {
 protected:
  void SetUp() override {
    static const bool has_no_page = desmo("view slider_crank") == 69;
    if (has_no_page) GTEST_SKIP() << "desmo was built without its page";
  }

  /// Returns the data that a page carries, as text.
  static std::string text_in(const std::string& page) {
    const std::size_t at = page.find('>', page.find("id=\"data\"")) + 1;
    return page.substr(at, page.find("</script>", at) - at);
  }
  static Json data_of(const std::string& page) { return Json::parse(text_in(page)); }
  /// Returns the data of the page that desmo view prints with these arguments.
  Json viewed(const std::string& arguments) { return data_of(printed("view " + arguments)); }

  /// Expects what a script prints that node runs on `data`, which the page of a scene reads; it may
  /// draw() them (drawing.js). Skips the test where there is no node.
  void expect_on_page_of(const std::string& scene, const std::string& script,
                         const std::string& printed) {
    desmo("view " + scene + " -o out/page.html");  // fails, and writes the page, where it locks
    const std::string page = text_of(out("page.html"));
    write("data", text_in(page));
    write(
        "script.mjs",
        std::string("import {readFileSync} from 'node:fs';\n"
                    "import {read} from '" DESMO_SOURCE_DIR "/bench/cli/view/data.js';\n"
                    "import {draw, layers} from '" DESMO_SOURCE_DIR "/bench/cli/view/drawing.js';\n"
                    "globalThis.document = {getElementById: id => (\n"
                    "    {textContent: readFileSync(id, 'utf8')})};\n"
                    "const data = read();\n") +
            script);
    if (shell("node script.mjs") == 127) GTEST_SKIP() << err_;
    EXPECT_EQ(out_, printed) << scene << err_;
  }
};

}  // namespace desmo
