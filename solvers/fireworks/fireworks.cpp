#include "solvers/fireworks/fireworks.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "solvers/fireworks/dynamic_fireworks.h"
#include "solvers/fireworks/loser_out_fireworks.h"
#include "solvers/fireworks/partitioned_fireworks.h"
#include "solvers/fireworks/population.h"
#include "solvers/fireworks/sparks.h"

namespace ricochet::fireworks {

namespace {

class FireworksRun {
 public:
  FireworksRun(Evaluator& evaluator, const FireworksOptions& options, Random& random)
      : evaluator_(evaluator),
        options_(options),
        random_(random),
        box_(evaluator.lower(), evaluator.upper()),
        coordinates_(box_.free()),
        unit_(options.amplitude_unit == AmplitudeUnit::of_x
                  ? Vector(Vector::Ones(box_.width().size()))
                  : box_.width()),
        budget_(static_cast<double>(evaluator.remaining())),
        population_(evaluator, options.fireworks + most_sparks(options.fireworks, options.counts) +
                                   options.gaussian_sparks) {}

  /// Each returns false once the evaluator refuses.
  bool begin(const Vector& start);
  bool explode();
  bool add_gaussian_sparks();

  void select() {
    population_.keep(selected(population_.points(), population_.worths(), options_.fireworks,
                              options_.selection, random_));
  }

 private:
  void draw_start(int number, const Vector& start);
  Vector amplitudes(const Vector& fitness) const;

  /// Evaluates spark_, a spark of this firework.
  bool add_spark(Eigen::Index firework) {
    box_.bring_back(spark_, options_.mapping, random_);
    if (options_.redraw_clones && spark_ == population_.point(firework)) box_.draw(spark_, random_);
    return population_.add(spark_);
  }

  Evaluator& evaluator_;
  const FireworksOptions& options_;
  Random& random_;
  Box box_;
  Coordinates coordinates_;
  Vector unit_;  // of amplitudes
  double budget_;
  Population population_;  // the fireworks first
  Vector spark_;
};

void FireworksRun::draw_start(int number, const Vector& start) {
  spark_ = start;
  if (options_.start_region) {
    const auto [lower, upper] = *options_.start_region;
    for (double& x : spark_) x = lower + share(random_) * (upper - lower);
  } else if (number > 0) {
    box_.draw(spark_, random_);
  }
  spark_ = spark_.cwiseMax(box_.lower()).cwiseMin(box_.upper());
}

bool FireworksRun::begin(const Vector& start) {
  for (int i = 0; i < options_.fireworks; ++i) {
    draw_start(i, start);
    if (!population_.add(spark_)) return false;
  }
  return true;
}

Vector FireworksRun::amplitudes(const Vector& fitness) const {
  const double spent = budget_ - static_cast<double>(evaluator_.remaining());
  const Vector free = explosion_amplitudes(fitness, options_.amplitude, options_.counts.epsilon);
  return free.cwiseMax(options_.amplitude_floor.after(spent, budget_));
}

bool FireworksRun::explode() {
  const Vector fitness = fitness_of(population_.worths());
  const std::vector<int> counts = spark_counts(fitness, options_.counts);
  const Vector amplitude = amplitudes(fitness);
  for (Eigen::Index i = 0; i < options_.fireworks; ++i) {
    for (int k = 0; k < counts[static_cast<std::size_t>(i)]; ++k) {
      spark_ = population_.point(i);
      displace(spark_, coordinates_.draw(options_.moved, random_), amplitude[i], unit_,
               options_.offsets, random_);
      if (!add_spark(i)) return false;
    }
  }
  return true;
}

bool FireworksRun::add_gaussian_sparks() {
  const auto fireworks = static_cast<std::size_t>(options_.fireworks);
  Vector best;
  if (options_.gaussian_spark == GaussianSpark::approaches) {
    const auto worths = population_.worths().first(fireworks);
    best = population_.point(best_of(worths, options_.selection.ties, random_));
  }
  for (int k = 0; k < options_.gaussian_sparks; ++k) {
    const auto i = static_cast<Eigen::Index>(one_of(fireworks, random_));
    spark_ = population_.point(i);
    const auto moved = coordinates_.draw(options_.gaussian_moved, random_);
    if (options_.gaussian_spark == GaussianSpark::multiplies) {
      multiply(spark_, moved, random_);
    } else {
      approach(spark_, moved, best, random_);
    }
    if (!add_spark(i)) return false;
  }
  return true;
}

void check(const FireworksOptions& options) {
  check_number("fireworks", options.fireworks);
  check(options.counts);
  if (!(options.amplitude >= 0)) throw std::invalid_argument("amplitude: must be >= 0");
  if (options.gaussian_sparks < 0) throw std::invalid_argument("gaussian_sparks: must be >= 0");
  const AmplitudeFloor& floor = options.amplitude_floor;
  if (!(floor.last >= 0 && floor.first >= floor.last)) {
    throw std::invalid_argument("amplitude_floor: needs 0 <= last <= first");
  }
}

}  // namespace

FireworksOptions paper_options() {
  return {};
}

FireworksOptions authors_options() {
  return {.moved = Moved::ceiled, .offsets = Offsets::one, .gaussian_moved = Moved::ceiled};
}

FireworksOptions corrected_options() {
  return {.counts = {.tied = TiedShare::equal},
          .amplitude = 0.2,
          .amplitude_unit = AmplitudeUnit::box_widths,
          .amplitude_floor = {.first = 0.02, .last = 0.001},
          .moved = Moved::ceiled,
          .gaussian_moved = Moved::ceiled,
          .gaussian_spark = GaussianSpark::approaches,
          .mapping = Mapping::redraw,
          .redraw_clones = true,
          .selection = {.ties = Ties::any, .others = Others::uniform}};
}

FireworksOptions enhanced_options() {
  return {.amplitude = 0.2,
          .amplitude_unit = AmplitudeUnit::box_widths,
          .amplitude_floor = {.first = 0.02, .last = 0.001},
          .moved = Moved::coins,
          .gaussian_moved = Moved::coins,
          .gaussian_spark = GaussianSpark::approaches,
          .mapping = Mapping::redraw,
          .selection = {.others = Others::uniform}};
}

Solver fireworks(std::string name, const FireworksOptions& options) {
  check(options);
  return member(std::move(name),
                [options](Evaluator& evaluator, const Vector& start, Random& random) {
                  FireworksRun show(evaluator, options, random);
                  if (!show.begin(start)) return;
                  while (show.explode() && show.add_gaussian_sparks()) show.select();
                });
}

namespace {

constexpr double largest_amplitude = 1e9;

constexpr Field growth_option = real_option("growth", 1, 1e3);
constexpr Field decline_option = real_option("decline", 1e-3, 1);
constexpr Field sparks_option = whole_option("sparks", 1);
constexpr Field fireworks_option = whole_option("fireworks", 1);
constexpr Field amplitude_option = real_option("amplitude", 0, largest_amplitude);

}  // namespace

template <class Visit, IsOf<BareBonesFireworksOptions>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(sparks_option, o.sparks...);
  visit(growth_option, o.steps.growth...);
  visit(decline_option, o.steps.decline...);
}

template <class Visit, IsOf<DynamicFireworksOptions>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(fireworks_option, o.fireworks...);
  visit(sparks_option, o.counts.sparks...);
  visit(amplitude_option, o.amplitude...);
  visit(growth_option, o.steps.growth...);
  visit(decline_option, o.steps.decline...);
}

template <class Visit, IsOf<LoserOutFireworksOptions>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(fireworks_option, o.fireworks...);
  visit(sparks_option, o.sparks...);
  visit(real_option("guiding_share", 1e-3, 1), o.guiding_share...);
  visit(whole_option("guiding_sparks", 1), o.guiding_sparks...);
  visit(growth_option, o.steps.growth...);
  visit(decline_option, o.steps.decline...);
}

template <class Visit, IsOf<PartitionedFireworksOptions>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(fireworks_option, o.fireworks...);
  visit(sparks_option, o.sparks...);
  visit(real_option("initial_scale", 1e-6, 1), o.initial_scale...);
  visit(whole_option("patience", 1), o.patience...);
}

template <class Visit, IsOf<FireworksOptions>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(fireworks_option, o.fireworks...);
  visit(sparks_option, o.counts.sparks...);
  visit(whole_option("gaussian_sparks", 0), o.gaussian_sparks...);
  visit(amplitude_option, o.amplitude...);
}

std::vector<AdjustableSolver> adjustable_family() {
  const auto member_of = [](const std::string& name, const auto& own, const auto& make) {
    return adjustable(name, own, [=](const auto& options) { return make(name, options); });
  };
  return {member_of("fireworks", paper_options(), fireworks),
          member_of("fireworks-authors", authors_options(), fireworks),
          member_of("fireworks-corrected", corrected_options(), fireworks),
          member_of("efwa", enhanced_options(), fireworks),
          member_of("dynfwa", DynamicFireworksOptions(), dynamic_fireworks),
          member_of("bbfwa", BareBonesFireworksOptions(), bare_bones_fireworks),
          member_of("bbfwa-tuned", tuned_options(), bare_bones_fireworks),
          member_of("lotfwa", LoserOutFireworksOptions(), loser_out_fireworks),
          member_of("mgfwa", multi_guiding_options(), loser_out_fireworks),
          member_of("fwassp", PartitionedFireworksOptions(), partitioned_fireworks)};
}

std::vector<Solver> family() {
  FireworksOptions as_printed = paper_options();
  as_printed.counts.third_branch = ThirdBranch::as_printed;
  return {fireworks("fireworks", paper_options()),
          fireworks("fireworks-as-printed", as_printed),
          fireworks("fireworks-authors", authors_options()),
          fireworks("fireworks-corrected", corrected_options()),
          fireworks("efwa", enhanced_options()),
          dynamic_fireworks("dynfwa"),
          bare_bones_fireworks("bbfwa"),
          bare_bones_fireworks("bbfwa-scaled", {.scaled = true}),
          bare_bones_fireworks("bbfwa-tuned", tuned_options()),
          loser_out_fireworks("lotfwa"),
          loser_out_fireworks("lotfwa-scaled", {.scaled = true}),
          loser_out_fireworks("mgfwa", multi_guiding_options()),
          partitioned_fireworks("fwassp")};
}

}  // namespace ricochet::fireworks
