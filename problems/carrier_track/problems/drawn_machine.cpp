#include "problems/carrier_track/questions/drawn_machine.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "problems/carrier_track/counting/sensitivity.h"
#include "src/core/random.h"
#include "src/core/seed.h"

namespace ricochet::carrier_track::inline questions {

Machine drawn_machine(Machine machine, int number) {
  if (number < 0) throw std::invalid_argument(fmt::format("machine {}: must be >= 0", number));
  if (number == 0) return machine;
  Random random(seed_of(machine.id, "drawn machine", number, 0));
  for (const std::string& key : constants_of(machine.scene)) {
    const double change = drawn_tolerance * (2 * uniform(random) - 1);
    machine.scene = scaled(std::move(machine.scene), key, 1 + change);
  }
  machine.id += fmt::format("~{}", number);
  machine.reading.clear();
  return machine;
}

}  // namespace ricochet::carrier_track::inline questions
