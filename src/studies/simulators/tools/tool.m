% What drivers in Octave of the impact test share: answers all scenes of the standard input by
% [impacts, end] = simulate(scene, level), with impacts {time s, wall, speed m/s} in a cell array,
% and level 1 (loose), 2 or 3 (tight). A missing upper wall is at Inf.
function tool(simulate)
  level = find(strcmp(argv(){end}, {"loose", "usual", "tight"}));
  do
    line = "";  % fread returns a byte at once, where fgetl waits for more
    while (! isempty(c = fread(stdin, 1, "uint8=>char")) && c != "\n") line(end + 1) = c; end
    if (isempty(line)) break; end
    scene = jsondecode(line);
    answer = struct("scene", scene.scene);
    try
      start = cputime();
      [impacts, last] = simulate(with_scales(scene), level);
      [answer.seconds, answer.impacts, answer.end] = deal(cputime() - start, impacts, last);
    catch failure
      answer.error = failure.message;
    end
    puts([jsonencode(answer) "\n"]); fflush(stdout);
  until (false)
end

% Adds to a scene its largest force [N], a length [m], a speed [m/s], and a step [s]: twenty in a
% period of the fastest force, and fifty in the duration.
function s = with_scales(s)
  if (isempty(s.upper)) s.upper = Inf; end
  s.length = s.upper - s.lower;
  if (isinf(s.length)) s.length = max(1e-3, s.position - s.lower); end
  s.strength = max(cellfun(@(terms) sum(abs([terms.amplitude](1, :))), {s.force.terms}));
  s.speed = max(abs(s.velocity), sqrt(2 * s.length * s.strength / s.mass));
  fastest = max(cellfun(@(terms) max(abs([terms.phase](2, :))), {s.force.terms}));
  s.longest_step = min(s.duration / 50, 2 * pi / 20 / max(fastest, 1e-9));
end
