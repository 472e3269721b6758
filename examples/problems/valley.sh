#!/bin/sh
# Prints the value and the constraint at the point in the file that is named.
awk '{ print (1 - $1)^2 + 100 * ($2 - $1^2)^2, $1^2 + $2^2 - 2 }' OFMT=%.17g "$1"
