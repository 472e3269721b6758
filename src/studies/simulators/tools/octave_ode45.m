% Octave's ode45 with events that end the integration. It finds an event by linear interpolation
% between two steps, and none in the first one: hence short steps.
warning("off", "all");
source(fullfile(fileparts(mfilename("fullpath")), "tool.m"));

function [impacts, last] = simulate(m, level)
  [tolerance, per_crossing, rest] = deal(10 ^ (-2 - 2 * level), [5 10 20](level), m.slowest / 4);
  [m.k, m.y, t, impacts] = deal(1, [m.position m.velocity], 0, {});
  [walls, bounce] = deal([m.lower m.upper], -[m.restitution_lower m.restitution_upper]);
  scale = m.scales;
  absolute = tolerance * [scale.length; scale.speed];
  options = odeset("RelTol", tolerance, "AbsTol", absolute, "Refine", 1);
  m = settle(m, t, false);
  for event = 1:20000
    if (t >= m.duration) last = m.y; return; end
    last = min([[m.force(m.k + 1:end).from], m.duration]);
    longest = min(last - t, scale.step);
    if (m.moves) longest = min(longest, scale.length / scale.speed / per_crossing); end
    [options.MaxStep, first] = deal(longest, rest * m.mass / scale.force);
    options.InitialStep = min(longest, first); options.Events = @(t, y) events(t, y, m);
    [ts, ys, ~, ~, w] = ode45(@(t, y) rates(t, y, m), [t last], m.y, options);
    [t, m.y, found, moved] = deal(ts(end), ys(end, :), ! isempty(w), m.moves);
    if (! found || last - t < 1e-12) m.k += last < m.duration; t = last; end
    if (found && moved && w(end) == 3) m.y(2) = 0;
    elseif (found && moved)
      approach = m.y(2) * [-1 1](w(end));
      if (approach > 0) impacts{end + 1} = {t, {"lower", "upper"}{w(end)}, approach}; end
      m.y = [walls(w(end)), m.y(2) * [1, bounce(w(end))](1 + (approach > 0))];
      if ((approach <= 0 || abs(m.y(2)) < rest) && hold(m, t) >= 0) m.y(2) = 0; end
    end
    if (found || ! moved) m = settle(m, t, found && ! moved); end
  end
  error("too many events");
end

tool(@simulate);
