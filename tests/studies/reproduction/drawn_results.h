#pragma once

#include <stdexcept>
#include <string>

#include "src/report/page_template.h"
#include "src/report/report.h"
#include "src/studies/reproduction/study.h"

namespace ricochet::studies::reproduction {

/// The data as they are read back from the file, with what every study adds.
inline report::Json kept_data(const Results& results) {
  report::Json data = report::Json::parse(data_of(results).dump());
  data["report"] = "reproduction";
  data["made"] = {{"version", "1.2.3"}, {"compiler", "none"}, {"threads", 2}, {"seconds", 1.5}};
  return data;
}

inline report::Page page_of(const report::Json& data) {
  return report::drawn(report::page_template("reproduction"), data).page;
}

inline const report::Section& section_of(const report::Page& page, const std::string& id) {
  for (const report::Section& section : page.sections) {
    if (section.id == id) return section;
  }
  throw std::out_of_range(id);
}

}  // namespace ricochet::studies::reproduction
