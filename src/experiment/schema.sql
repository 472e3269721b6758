-- A campaign of ricochet. Of a number that SQLite would change, -0.0 or not a number, the eight
-- bytes of its double are kept, little-endian, as a blob; of a point those of all its coordinates.
PRAGMA application_id = 0x5249434F;  -- the user_version is that of the suite

CREATE TABLE campaign (
  plan TEXT NOT NULL,        -- TOML
  checksum INTEGER NOT NULL  -- of the whole description; that of a run is of its key, too
);

-- Notes about 'content' have the hash of the files of a user's solver, by its name. (This stands
-- outside of the definition, which stores of earlier versions must have word for word.)
CREATE TABLE note (
  about TEXT NOT NULL,  -- 'program', or 'made': where and when
  name TEXT NOT NULL,
  value TEXT NOT NULL,
  PRIMARY KEY (about, name)
) WITHOUT ROWID;

CREATE TABLE problem (
  number INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE,
  family TEXT NOT NULL,
  machine TEXT NOT NULL,  -- '': asked of none
  variables INTEGER NOT NULL,
  constraints INTEGER NOT NULL,
  equalities INTEGER NOT NULL,
  tolerance REAL NOT NULL,  -- optimality gap that still counts as solved
  best_known REAL NOT NULL,
  hash TEXT NOT NULL  -- of all that its runs' scores rest on, 16 hexadecimal digits
);

CREATE TABLE factor (  -- of the problem's machine
  problem INTEGER NOT NULL REFERENCES problem,
  name TEXT NOT NULL,
  value REAL NOT NULL,
  PRIMARY KEY (problem, name)
) WITHOUT ROWID;

CREATE TABLE finding (  -- of the search for the problem's best value
  problem INTEGER NOT NULL REFERENCES problem,
  name TEXT NOT NULL,
  value REAL NOT NULL,
  PRIMARY KEY (problem, name)
) WITHOUT ROWID;

CREATE TABLE solver (
  number INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE,
  version TEXT NOT NULL
);

CREATE TABLE cell (  -- runs of it differ in instance and run only
  number INTEGER PRIMARY KEY,
  problem INTEGER NOT NULL REFERENCES problem,
  formulation TEXT NOT NULL,
  perturbation TEXT NOT NULL,
  solver INTEGER NOT NULL REFERENCES solver,
  budget INTEGER NOT NULL,  -- evaluations for each variable
  gradient_price TEXT NOT NULL,
  UNIQUE (problem, formulation, perturbation, solver, budget, gradient_price)
);

CREATE TABLE termination_reason (  -- why the evaluator refused in the end
  number INTEGER PRIMARY KEY,
  name TEXT NOT NULL
);
INSERT INTO termination_reason VALUES
  (0, 'none'), (1, 'evaluations'), (2, 'seconds'), (3, 'bad point'), (4, 'failure'), (5, 'paused');

CREATE TABLE run (
  number INTEGER PRIMARY KEY,
  cell INTEGER NOT NULL REFERENCES cell,
  instance INTEGER NOT NULL,
  run INTEGER NOT NULL,
  problem TEXT NOT NULL,       -- as the run itself names problem, solver, instance, run
  solver_name TEXT NOT NULL,
  own_instance INTEGER NOT NULL,
  own_run INTEGER NOT NULL,
  seed INTEGER NOT NULL,       -- 64 bits; 2^64 more where it is negative
  evaluations_allowed INTEGER NOT NULL,
  seconds_allowed REAL NOT NULL,
  values_asked INTEGER NOT NULL,
  derivatives_asked INTEGER NOT NULL,
  hessians_asked INTEGER NOT NULL,
  charged INTEGER NOT NULL,    -- evaluations
  refused INTEGER NOT NULL,    -- calls
  seconds REAL NOT NULL,       -- of processor time, scoring left out
  termination_reason INTEGER NOT NULL REFERENCES termination_reason,
  failure TEXT NOT NULL,       -- what was thrown; '' if nothing
  best_x BLOB,                 -- point of the last improvement; NULL where there is none
  returned_x BLOB,             -- the best point that the solver returned, by its formulation
  returned_objective REAL,     -- its true values
  returned_violation REAL,
  checksum INTEGER NOT NULL,
  UNIQUE (cell, instance, run)
);

CREATE TABLE improvement (  -- points truly better than all before them in their run
  run INTEGER NOT NULL REFERENCES run,
  step INTEGER NOT NULL,         -- 0, 1, ...
  evaluations INTEGER NOT NULL,  -- charged when it was found
  seconds REAL NOT NULL,
  objective REAL NOT NULL,
  violation REAL NOT NULL,
  PRIMARY KEY (run, step)
) WITHOUT ROWID;

CREATE TABLE reason (
  number INTEGER PRIMARY KEY,
  text TEXT NOT NULL UNIQUE
);

CREATE TABLE termination (  -- what the solver reported at the end of its starts, in their order
  run INTEGER NOT NULL REFERENCES run,
  step INTEGER NOT NULL,
  reason INTEGER NOT NULL REFERENCES reason,
  starts INTEGER NOT NULL,  -- in a row that ended so
  PRIMARY KEY (run, step)
) WITHOUT ROWID;

CREATE VIEW result AS  -- every run in words, with the best it reached
SELECT run.number, problem.name AS problem, cell.formulation, cell.perturbation,
       solver.name AS solver, cell.budget, cell.gradient_price, run.instance, run.run, run.charged, run.seconds,
       termination_reason.name AS termination_reason, best.evaluations AS found_after,
       best.objective, best.violation, run.failure
FROM run
JOIN cell ON cell.number = run.cell
JOIN problem ON problem.number = cell.problem
JOIN solver ON solver.number = cell.solver
JOIN termination_reason ON termination_reason.number = run.termination_reason
LEFT JOIN improvement AS best ON best.run = run.number
  AND best.step = (SELECT max(step) FROM improvement WHERE improvement.run = run.number);
