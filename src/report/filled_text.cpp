#include "src/report/filled_text.h"

#include <fmt/format.h>

#include <deque>
#include <kainjow/mustache.hpp>
#include <stdexcept>
#include <unordered_map>

namespace ricochet::report {
namespace {

namespace mustache = kainjow::mustache;

const Json* looked_up(const Json& scope, const std::string& name) {
  const Json* data = &scope;
  std::size_t start = 0;
  while (start <= name.size()) {
    const std::size_t end = std::min(name.find('.', start), name.size());
    if (!data->is_object()) return nullptr;
    const auto found = data->find(name.substr(start, end - start));
    if (found == data->end()) return nullptr;
    data = &*found;
    start = end + 1;
  }
  return data;
}

std::string formatted(const Json& data, std::string formulation, const std::string& name) {
  if (data.is_null()) return "–";
  double scale = 1;
  if (formulation.ends_with('%')) {
    scale = 100;
    formulation.back() = 'f';
  }
  formulation = "{:" + formulation + "}";
  // An integer in the data may be a number with a zero fraction: the format decides.
  const bool fraction = formulation.find_first_of("eEfFgG.") != std::string::npos;
  try {
    if (data.is_string()) return fmt::format(fmt::runtime(formulation), data.get<std::string>());
    if (data.is_number_integer() && !fraction) {
      return fmt::format(fmt::runtime(formulation), data.get<std::int64_t>());
    }
    if (data.is_number()) {
      const auto text = [&](double value) { return fmt::format(fmt::runtime(formulation), value); };
      const std::string exact = text(scale * data.get<double>());
      return exact == text(-0.0) ? text(0.0) : exact;
    }
  } catch (const fmt::format_error& error) {
    throw std::logic_error(
        fmt::format("a template's {} as {}: {}", name, formulation, error.what()));
  }
  throw std::logic_error(fmt::format("a template's {} is neither number nor text", name));
}

/// Answers Mustache's look-ups of names from JSON.
class Context : public mustache::basic_context<std::string> {
 public:
  explicit Context(const Scopes& scopes) : scopes_(scopes) {}

  void push(const mustache::data* node) override {
    const auto found = source_.find(node);
    // A condition without entries adds no scope.
    const bool condition = found == source_.end();
    scopes_.push_back(condition ? scopes_.back() : found->second.data);
    places_.push_back(condition ? places_.back() : found->second.place);
  }
  void pop() override {
    scopes_.pop_back();
    places_.pop_back();
  }

  const mustache::data* get(const std::string& asked) const override {
    if (asked == "@first") return keep(places_.back().first);
    if (asked == "@last") return keep(places_.back().last);
    const std::size_t colon = asked.find(':');
    const std::string name = asked.substr(0, colon);
    const Json& data = found_in(scopes_, name);
    if (colon != std::string::npos) return keep(formatted(data, asked.substr(colon + 1), name));
    if (!is_yes(data)) return keep(false);
    if (data.is_array()) return keep_list(data);
    if (data.is_object()) {
      const mustache::data* node = keep(true);
      source_[node] = {&data, places_.back()};
      return node;
    }
    if (data.is_boolean()) return keep(true);
    return keep(formatted(data, "", name));
  }

  const mustache::data* get_partial(const std::string& /*name*/) const override { return nullptr; }

 private:
  template <class Value>
  const mustache::data* keep(Value value) const {
    return &nodes_.emplace_back(std::move(value));
  }

  const mustache::data* keep_list(const Json& data) const {
    mustache::data list{mustache::data::type::list};
    for (std::size_t i = 0; i < data.size(); ++i) list << mustache::data{true};
    const mustache::data& node = nodes_.emplace_back(std::move(list));
    for (std::size_t i = 0; i < data.size(); ++i) {
      source_[&node.list_value()[i]] = {&data[i], {i == 0, i + 1 == data.size()}};
    }
    return &node;
  }

  struct Place {
    bool first, last;  ///< of its list
  };
  struct Source {
    const Json* data;
    Place place;
  };

  Scopes scopes_;
  std::vector<Place> places_ = {{true, true}};  // of the scopes
  mutable std::deque<mustache::data> nodes_;    // addresses must remain valid
  mutable std::unordered_map<const mustache::data*, Source> source_;
};

}  // namespace

const Json& found_in(const Scopes& scopes, const std::string& name) {
  if (name == "." && !scopes.empty()) return *scopes.back();
  for (auto scope = scopes.rbegin(); scope != scopes.rend(); ++scope) {
    if (const Json* data = looked_up(**scope, name)) return *data;
  }
  throw std::logic_error(
      fmt::format("a template asks for \"{}\", which the data do not have", name));
}

bool is_yes(const Json& data) {
  if (data.is_boolean()) return data.get<bool>();
  if (data.is_string()) return !data.get_ref<const std::string&>().empty();
  return !data.is_null() && !(data.is_array() && data.empty());
}

std::string filled(const std::string& text, const Scopes& scopes) {
  mustache::mustache sheet(text);
  sheet.set_custom_escape([](const std::string& plain) { return plain; });
  Context context(scopes);
  std::string result = sheet.render(context);
  if (!sheet.is_valid()) {
    throw std::logic_error(fmt::format("a template, \"{}\": {}", text, sheet.error_message()));
  }
  return result;
}

}  // namespace ricochet::report
