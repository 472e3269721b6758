% Collisions over the speed, and Octave's own optimiser on a problem:
% mkoctfile --mex ricochet_mex.c -lricochet, then octave-cli minimise.m.
speeds = linspace(5, 7, 201);
counts = ricochet_mex("machine", "machine.toml", speeds);
printf("first collisions at %.2f rad/s\n", speeds(find(counts > 0, 1)));

name = "classic-rosenbrock-2";
box = ricochet_mex("box", name);
[x, least] = fminsearch(@(x) ricochet_mex("problem", name, x), box(:, 3)');
printf("minimum %.2f at %.2f %.2f\n", least, x);
