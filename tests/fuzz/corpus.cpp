#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "cases/io/text_file.h"
#include "cases/library/library.h"
#include "tests/fuzz/mutator.h"

namespace desmo::fuzz {

std::vector<Sample> load_folder(const std::filesystem::path& folder) {
  std::vector<Sample> samples;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".json") continue;
    samples.push_back({file.path().filename().string(), read_text(file.path())});
  }
  if (samples.empty()) throw std::runtime_error(folder.string() + ": no JSON files in it");
  std::ranges::sort(samples, {}, &Sample::name);
  return samples;
}

std::vector<Sample> load_corpus(const std::filesystem::path& folder) {
  std::vector<Sample> samples;
  for (const LibraryMechanism& l : library()) {
    const std::string name(l.name);
    samples.push_back({name + ".json", std::string(l.mechanism)});
    samples.push_back({name + ".scene.json", std::string(l.scene)});
    Json scene = Json::parse(l.scene);
    scene["mechanism"] = Json::parse(l.mechanism);
    samples.push_back({name + ".whole.json", write(scene)});
  }
  for (const RequestScene& r : request_scenes())
    samples.push_back({std::string(r.name) + ".scene.json", std::string(r.scene)});
  std::ranges::move(load_folder(folder), std::back_inserter(samples));
  return samples;
}

}  // namespace desmo::fuzz
