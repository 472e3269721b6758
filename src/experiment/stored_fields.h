#pragma once

#include "ricochet/run.h"
#include "src/core/fields.h"
#include "src/experiment/store.h"

/// The fields of what stores keep, and in which order: for the workers' messages, checksums and
/// digests, the tables of a store and its exports.
namespace ricochet {

template <class Visit, IsOf<Budget>... B>
void visit_fields(const Visit& visit, B&... b) {
  visit(Field{"evaluations", "1"}, b.evaluations...);
  visit(Field{"seconds", "s"}, b.seconds...);
  visit(Field{"gradient_price", "1"}, b.gradient_price...);
}

template <class Visit, IsOf<Ledger>... L>
void visit_fields(const Visit& visit, L&... l) {
  visit(Field{"values", "1"}, l.values...);
  visit(Field{"derivatives", "1"}, l.derivatives...);
  visit(Field{"hessians", "1"}, l.hessians...);
  visit(Field{"charged", "1"}, l.charged...);
  visit(Field{"refused", "1"}, l.refused...);
  visit(Field{"seconds", "s"}, l.seconds...);
}

template <class Visit, IsOf<TrueValues>... V>
void visit_fields(const Visit& visit, V&... v) {
  visit(Field{"objective", "1"}, v.objective...);
  visit(Field{"violation", "1"}, v.violation...);
}

template <class Visit, IsOf<Improvement>... I>
void visit_fields(const Visit& visit, I&... i) {
  visit(Field{"evaluations", "1"}, i.evaluations...);
  visit(Field{"seconds", "s"}, i.seconds...);
  visit(Field{"true_values"}, i.true_values...);
  visit(Field{"x", "1"}, i.x...);
}

template <class Visit, IsOf<SolverTermination>... T>
void visit_fields(const Visit& visit, T&... t) {
  visit(Field{"reason"}, t.reason...);
  visit(Field{"point", "1"}, t.point...);
}

template <class Visit, IsOf<ReturnedPoint>... P>
void visit_fields(const Visit& visit, P&... p) {
  visit(Field{"x", "1"}, p.x...);
  visit(Field{"true_values"}, p.true_values...);
}

template <class Visit, IsOf<RunRecord>... R>
void visit_fields(const Visit& visit, R&... r) {
  visit(Field{"problem"}, r.problem...);
  visit(Field{"solver"}, r.solver...);
  visit(Field{"instance", "1"}, r.instance...);
  visit(Field{"run", "1"}, r.run...);
  visit(Field{"seed", "1"}, r.seed...);
  visit(Field{"budget"}, r.budget...);
  visit(Field{"ledger"}, r.ledger...);
  visit(Field{"termination_reason"}, r.termination_reason...);
  visit(Field{"terminations"}, r.terminations...);
  visit(Field{"returned"}, r.returned...);
  visit(Field{"failure"}, r.failure...);
  visit(Field{"trace"}, r.trace...);
}

template <class Visit, IsOf<RunKey>... K>
void visit_fields(const Visit& visit, K&... k) {
  visit(Field{"problem"}, k.cell.problem...);
  visit(Field{"formulation"}, k.cell.formulation...);
  visit(Field{"perturbation"}, k.cell.perturbation...);
  visit(Field{"solver"}, k.cell.solver...);
  visit(Field{"budget_per_variable", "1"}, k.cell.budget...);
  visit(Field{"gradient_price"}, k.cell.gradient_price...);
  visit(Field{"instance", "1"}, k.instance...);
  visit(Field{"run", "1"}, k.run...);
}

/// Without its maps, which other tables have.
template <class Visit, IsOf<StoredProblem>... P>
void visit_columns(const Visit& visit, P&... p) {
  visit(Field{"name"}, p.name...);
  visit(Field{"family"}, p.family...);
  visit(Field{"machine"}, p.machine...);
  visit(Field{"variables", "1"}, p.variables...);
  visit(Field{"constraints", "1"}, p.constraints...);
  visit(Field{"equalities", "1"}, p.equalities...);
  visit(Field{"tolerance"}, p.tolerance...);
  visit(Field{"best_known"}, p.best_known...);
  visit(Field{"hash"}, p.hash...);
}

template <class Visit, IsOf<StoredProblem>... P>
void visit_fields(const Visit& visit, P&... p) {
  visit_columns(visit, p...);
  visit(Field{"factors"}, p.factors...);
  visit(Field{"findings"}, p.findings...);
}

template <class Visit, IsOf<StoredSolver>... S>
void visit_fields(const Visit& visit, S&... s) {
  visit(Field{"name"}, s.name...);
  visit(Field{"version"}, s.version...);
  visit(Field{"content"}, s.content...);
}

}  // namespace ricochet
