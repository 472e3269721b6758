% ricochet from Octave or MATLAB, by the glue of ricochet_mex.c: mkoctfile --mex ricochet_mex.c -lricochet
[counts, quiet] = ricochet_mex("machine", "machine.toml", [5 6 7]);
printf("collisions %d %d %d, quiet up to %.3f rad/s\n", counts, quiet);
[objective, constraints, best_known] = ricochet_mex("problem", "hs-71", [1 5 5 1]);
printf("hs-71: %g, constraints %g %g, best known %.6f\n", objective, constraints, best_known);
