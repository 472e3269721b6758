# ricochet from R, by the glue of for_r.c: R CMD SHLIB for_r.c -lricochet, then Rscript ask.R.
dyn.load("for_r.so")

machine <- .Call("open_machine", "machine.toml")
counts <- .Call("counts", machine, c(5, 6, 7))
quiet <- .Call("quiet_speed", machine)
cat(sprintf("collisions %s, quiet up to %.3f rad/s\n", paste(counts, collapse = " "), quiet))

problem <- .Call("open_problem", "hs-71")
values <- .Call("values", problem, c(1, 5, 5, 1))
cat(sprintf("hs-71: %g, constraints %s, best known %.6f\n", values[1],
            paste(values[-1], collapse = " "), .Call("best_known", problem)))
