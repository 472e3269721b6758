# Collisions over the speed, and R's own optimiser on a problem: R CMD SHLIB for_r.c -lricochet, then
# Rscript minimise.R.
dyn.load("for_r.so")

machine <- .Call("open_machine", "machine.toml")
speeds <- seq(5, 7, length.out = 201)
counts <- .Call("counts", machine, speeds)
cat(sprintf("first collisions at %.2f rad/s\n", speeds[counts > 0][1]))

problem <- .Call("open_problem", "classic-rosenbrock-2")
box <- .Call("box", problem)
found <- optim(box[, 3], function(x) .Call("values", problem, x)[1], method = "L-BFGS-B",
               lower = box[, 1], upper = box[, 2])
cat(sprintf("minimum %.2f at %.2f %.2f\n", found$value, found$par[1], found$par[2]))
