# The tables of `ricochet export STORE --format csv --out tables` as data frames: Rscript examples/load_runs.R tables
folder <- commandArgs(trailingOnly = TRUE)[1]
files <- list.files(folder, pattern = "[.]csv$", full.names = TRUE)
tables <- lapply(files, read.csv, na.strings = "")
names(tables) <- sub("[.]csv$", "", basename(files))
runs <- merge(tables$runs, tables$problems, by = "problem")
runs <- merge(runs, subset(tables$points, point == "returned"), by = "number", all.x = TRUE)
print(aggregate(returned_solved ~ family + solver + formulation + perturbation, runs, mean))
