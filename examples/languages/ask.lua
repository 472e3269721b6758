-- ricochet from LuaJIT: luajit ask.lua, with the library where the system finds it.
local ffi = require("ffi")
ffi.cdef [[
typedef struct ricochet_machine ricochet_machine;
typedef struct ricochet_problem ricochet_problem;
const char* ricochet_error(void);
ricochet_machine* ricochet_open_machine(const char* file);
void ricochet_close_machine(ricochet_machine* machine);
int32_t ricochet_counts(const ricochet_machine*, const double* omegas, int64_t size, int32_t*);
int32_t ricochet_quiet_speed(const ricochet_machine*, const char* measure, double at_most,
                             double fastest, double* quiet, double* first_loud, double* limit);
ricochet_problem* ricochet_open(const char* problem, const char* formulation, int32_t instance,
                                int64_t budget, uint64_t seed);
void ricochet_close(ricochet_problem* problem);
int32_t ricochet_values(ricochet_problem*, const double* x, double* objective, double* constraints);
double ricochet_best_known(const ricochet_problem* problem);
]]
local ricochet = ffi.load("ricochet")

local function opened(pointer, close)
  if pointer == nil then error(ffi.string(ricochet.ricochet_error()), 0) end
  return ffi.gc(pointer, close)
end

local machine = opened(ricochet.ricochet_open_machine("machine.toml"), ricochet.ricochet_close_machine)
local counts, quiet = ffi.new("int32_t[3]"), ffi.new("double[1]")
ricochet.ricochet_counts(machine, ffi.new("double[3]", 5, 6, 7), 3, counts)
ricochet.ricochet_quiet_speed(machine, nil, 0, 18, quiet, nil, nil)
print(("collisions %d %d %d, quiet up to %.3f rad/s"):format(counts[0], counts[1], counts[2], quiet[0]))

local problem = opened(ricochet.ricochet_open("hs-71", "", 0, 1000, 0), ricochet.ricochet_close)
local objective, constraints = ffi.new("double[1]"), ffi.new("double[2]")
ricochet.ricochet_values(problem, ffi.new("double[4]", 1, 5, 5, 1), objective, constraints)
print(("hs-71: %g, constraints %g %g, best known %.6f"):format(objective[0], constraints[0],
  constraints[1], ricochet.ricochet_best_known(problem)))
