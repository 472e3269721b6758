#include "src/report/site/live_page.h"

#include "embedded/live_charts.h"
#include "embedded/live_controls.h"
#include "embedded/live_default_machine.h"
#include "embedded/live_look.h"
#include "embedded/live_machine.h"
#include "embedded/live_machine_file.h"
#include "embedded/live_map_chart.h"
#include "embedded/live_module.h"
#include "embedded/live_page_script.h"
#include "embedded/live_picture.h"
#include "embedded/live_race.h"
#include "embedded/live_sentences.h"
#include "embedded/live_state.h"
#include "embedded/live_template.h"
#include "embedded/live_toml.h"
#include "embedded/live_window_charts.h"
#include "embedded/live_workers.h"
#include "embedded/look.h"
#include "src/report/filled_text.h"

namespace ricochet::site {

std::string live_page(const std::string& navigation) {
  std::string scripts;
  for (const char* script :
       {embedded::live_machine_file, embedded::live_state, embedded::live_workers,
        embedded::live_charts, embedded::live_picture, embedded::live_window_charts,
        embedded::live_map_chart, embedded::live_race, embedded::live_controls,
        embedded::live_sentences, embedded::live_page_script}) {
    scripts += script;
  }
  const Json page = {
      {"navigation", navigation},           {"look", embedded::look},
      {"live_look", embedded::live_look},   {"default_machine", embedded::live_default_machine},
      {"module", embedded::live_module},    {"machine_script", embedded::live_machine},
      {"toml_script", embedded::live_toml}, {"scripts", scripts}};
  return report::filled(embedded::live_template, {&page});
}

}  // namespace ricochet::site
