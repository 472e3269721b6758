#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

#include "src/benchmark/analysis/outcome.h"

namespace ricochet::comparison {

/// The runs of a cell, or every k-th of them. They do not change, and copies share them, so that
/// many selections of a million runs need one copy only.
class Outcomes {
 public:
  class Iterator {
   public:
    Iterator(const Outcomes& outcomes, std::size_t place) : outcomes_(outcomes), place_(place) {}
    const Outcome& operator*() const { return outcomes_[place_]; }
    Iterator& operator++() { return ++place_, *this; }
    bool operator!=(const Iterator& other) const { return place_ != other.place_; }

   private:
    const Outcomes& outcomes_;
    std::size_t place_;
  };

  Outcomes() = default;
  Outcomes(std::vector<Outcome> all)  // NOLINT(google-explicit-constructor): it is nothing else
      : all_(std::make_shared<const std::vector<Outcome>>(std::move(all))), size_(all_->size()) {}
  Outcomes(std::initializer_list<Outcome> all) : Outcomes(std::vector<Outcome>(all)) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const Outcome& operator[](std::size_t i) const { return (*all_)[first_ + i * step_]; }
  const Outcome& front() const { return (*this)[0]; }
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size_}; }

  /// `size` of them: the one at `first` and every `step`-th after it; all must exist.
  Outcomes every(std::size_t step, std::size_t first, std::size_t size) const {
    Outcomes part = *this;
    part.first_ = first_ + first * step_;
    part.step_ = step_ * step;
    part.size_ = size;
    return part;
  }

 private:
  std::shared_ptr<const std::vector<Outcome>> all_;
  std::size_t first_ = 0, step_ = 1, size_ = 0;
};

}  // namespace ricochet::comparison
