% What drivers in Octave share. tool(simulate) answers all scenes of the standard input by
% [impacts, end] = simulate(scene, level), with impacts {time s, wall, speed m/s} in a cell array,
% and level 1 (loose), 2 or 3 (tight). A missing upper wall is at Inf. The motion between events is
% that of m: a scene with its segment k, the state y, whether it moves, and in which direction.
1;

function f = force(m, t)  % N
  u = (t - m.force(m.k).from) .^ (0:2);
  f = sum((u * [m.force(m.k).terms.amplitude]) .* cos(u * [m.force(m.k).terms.phase]));
end

function h = hold(m, t)  % N; at rest: what is missing to a force that moves the body
  h = m.friction - max([1 -1]([m.y(1) < m.upper, m.y(1) > m.lower]) * force(m, t));
end

function dy = rates(t, y, m)
  dy = m.moves * [y(2); (force(m, t) - m.direction * m.friction) / m.mass];
end

function [values, terminal, falling] = events(t, y, m)
  values = [y(1) - m.lower, min(m.upper - y(1), 1), m.direction * y(2)](1:2 + (m.friction > 0));
  if (! m.moves) values = hold(m, t); end
  [terminal, falling] = deal(ones(size(values)), -ones(size(values)));
end

function m = settle(m, t, released)  % whether it moves, and in which direction
  m.moves = released || m.y(2) != 0 || hold(m, t) < 0;
  m.direction = sign(m.y(2) + (m.y(2) == 0) * force(m, t));
end

function tool(simulate)
  level = find(strcmp(argv(){end}, {"loose", "usual", "tight"}));
  do
    line = "";  % fread returns a byte at once, where fgetl waits for more
    while (! isempty(c = fread(stdin, 1, "uint8=>char")) && c != "\n") line(end + 1) = c; end
    if (isempty(line)) break; end
    scene = jsondecode(line);
    if (isempty(scene.upper)) scene.upper = Inf; end
    answer = struct("scene", scene.scene);
    try
      start = cputime();
      [answer.impacts, answer.end] = simulate(scene, level);
      answer.seconds = cputime() - start;
    catch failure
      answer.error = failure.message;
    end
    puts([jsonencode(answer) "\n"]); fflush(stdout);
  until (false)
end
