// See entry.h.
// SPDX-License-Identifier: MIT
#include "conformance/report/entry.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "conformance/pictures.h"

namespace clearpipe::conformance::report {

namespace {

using nlohmann::json;

json figures(const Agreement& agreement) {
  return {{"equal", agreement.equal},
          {"within_1", agreement.within_1},
          {"near", agreement.near},
          {"far", agreement.far},
          {"largest", agreement.largest}};
}

json headings(const Entry& entry) {
  return {{"chapter", entry.chapter},
          {"section", entry.section},
          {"name", entry.name},
          {"note", entry.note},
          {"tolerance",
           {{"near", entry.tolerance.near},
            {"near_share", entry.tolerance.near_share},
            {"far", entry.tolerance.far},
            {"far_share", entry.tolerance.far_share},
            {"reason", entry.tolerance.reason != nullptr ? entry.tolerance.reason : ""}}}};
}

json of_second(const Entry& entry) {
  const Second& second = entry.second;
  if (second.name.empty()) return nullptr;
  json result = {{"name", second.name}, {"complaint", second.complaint}, {"cause", second.cause}};
  if (second.image.pixels.empty()) return result;
  result["with_reference"] = figures(second.with_reference);
  result["with_subject"] = figures(second.with_subject);
  if (second.with_reference.equal < 1) {
    result["picture"] = data_uri(wrap(second.image));
    result["difference"] = data_uri(amplified_difference(second.image, entry.reference));
  }
  return result;
}

}  // namespace

json as_json(const Entry& entry) {
  json result = headings(entry);
  result["good"] = holds(entry.agreement, entry.tolerance);
  result["complaint"] = "";
  result["size"] = {entry.subject.width, entry.subject.height};
  result["reference_name"] = entry.reference_name;
  result["figures"] = figures(entry.agreement);
  result["pictures"] = {
      {"subject", data_uri(wrap(entry.subject))},
      {"reference", data_uri(wrap(entry.reference))},
      {"difference", data_uri(amplified_difference(entry.subject, entry.reference))}};
  result["second"] = of_second(entry);
  return result;
}

json as_json_without_pictures(const Entry& entry, const std::string& complaint) {
  json result = headings(entry);
  result["good"] = false;
  result["complaint"] = complaint;
  return result;
}

void write_record(const json& record, const std::string& folder) {
  std::filesystem::create_directories(folder);
  const std::string path = folder + "/" + record.at("name").get<std::string>() + ".json";
  std::ofstream file(path);
  file << record.dump();
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path);
}

json read_records(const std::string& folder) {
  std::vector<json> records;
  for (const auto& item : std::filesystem::directory_iterator(folder)) {
    if (item.path().extension() != ".json") continue;
    std::ifstream file(item.path());
    records.push_back(json::parse(file));
  }
  const auto key = [](const json& record) {
    // Sections are numbered, and 2.11 comes after 2.8.
    const std::string& section = record.at("section").get_ref<const std::string&>();
    int major = 0, minor = 0;
    std::sscanf(section.c_str(), "%d.%d", &major, &minor);
    return std::make_tuple(record.at("chapter").get<std::string>(), major, minor, section,
                           record.at("name").get<std::string>());
  };
  std::sort(records.begin(), records.end(),
            [&](const json& a, const json& b) { return key(a) < key(b); });
  return records;
}

}  // namespace clearpipe::conformance::report
