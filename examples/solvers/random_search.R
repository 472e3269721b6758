# Random search in R, with the package jsonlite: Rscript examples/solvers/random_search.R
# The input is opened once. readLines(file("stdin"), 1) would open it again for every line, and lose
# what the connection before had read ahead; stdin() is this script itself.
library(jsonlite)
input <- file("stdin", "r")

say <- function(message) {
  cat(toJSON(message, auto_unbox = TRUE, digits = NA), "\n", sep = "")
  flush(stdout())
}

ask <- function(x) {
  say(list(ask = I(x)))
  fromJSON(readLines(input, n = 1))
}

say(list(name = "r-random-search", stochastic = TRUE))
while (length(line <- readLines(input, n = 1)) > 0) {
  problem <- fromJSON(line)
  set.seed(problem$seed %% 2^31)
  x <- problem$start
  answer <- ask(x)
  while (is.null(answer$stop)) {
    x <- problem$lower + runif(length(x)) * (problem$upper - problem$lower)
    answer <- ask(x)
  }
  say(list(done = "stopped"))
}
