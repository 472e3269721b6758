#pragma once

#include "ricochet/scene.h"
#include "tests/carrier_track/models/brute_force.h"

namespace ricochet::carrier_track {

/// Force [N] of equation (22) on a body, but for contact and friction, straight from the formula.
double applied_force_across(const Scene& scene, double time);

/// The brute force in two directions, for scenes with Scene::across: it shares nothing with the
/// planar model but the scene, and takes its conventions for friction and impacts from the words of
/// planar_model.h. The result is that of x.
BruteForce planar_brute_force(const Scene& scene, double step);

}  // namespace ricochet::carrier_track
