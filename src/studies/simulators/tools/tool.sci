// What drivers in Scilab of the impact test share: tool() answers all scenes of the standard input
// by [impacts, last] = simulate(scene, level), with a row [time s, wall 1 or 2, speed m/s] for each
// impact, the last [m, m/s], and level 1 (loose), 2 or 3 (tight). A missing upper wall is at %inf.

// The force [N] at time t [s] in the scene's segment m.k.
function f = force(m, t)  // N
    u = (t - m.from(m.k)) .^ [0; 1; 2];
    f = sum((m.segments(m.k)(:, 1:3) * u) .* cos(m.segments(m.k)(:, 4:6) * u));
endfunction

// Adds to a scene its segments, each with a row [amplitude, phase] a term, its largest force [N], a
// length [m], a speed [m/s], and a step [s]: twenty in a period of the fastest force, and fifty in
// the duration.
function s = with_scales(s)
    if s.upper == "null" then s.upper = %inf; end
    s.from = []; s.segments = list(); s.strength = 0; fastest = 1e-9;
    for k = 1:size(s.force, "*")
        terms = [];
        part = s.force(k).terms;
        for j = 1:size(part, "*"), terms(j, 1:6) = [part(j).amplitude, part(j).phase]; end
        s.from(k) = s.force(k).from;
        s.segments(k) = terms;
        s.strength = max(s.strength, sum(abs(terms(:, 1))));
        fastest = max([fastest; abs(terms(:, 5))]);
    end
    s.span = s.upper - s.lower;
    if isinf(s.span) then s.span = max(1e-3, s.position - s.lower); end
    s.speed = max(abs(s.velocity), sqrt(2 * s.span * s.strength / s.mass));
    s.longest_step = min(s.duration / 50, 2 * %pi / 20 / fastest);
endfunction

function tool()
    words = sciargs();
    level = find(words($) == ["loose", "usual", "tight"]);
    line = mgetl(%io(1), 1);
    while line <> [] & line <> ""
        scene = fromJSON(line);
        try
            timer();
            [impacts, last] = simulate(with_scales(scene), level);
            texts = [];
            names = ["lower", "upper"];
            for k = 1:size(impacts, 1)
                texts(k) = msprintf("[%.17g,""%s"",%.17g]", impacts(k, 1), names(impacts(k, 2)), ..
                                    impacts(k, 3));
            end
            if texts == [] then texts = ""; end
            mprintf("{""scene"":""%s"",""seconds"":%g,""end"":[%.17g,%.17g],""impacts"":[%s]}\n", ..
                scene.scene, timer(), last(1), last(2), strcat(texts, ","));
        catch
            mprintf("{""scene"":""%s"",""error"":""%s""}\n", scene.scene, ..
                strsubst(strsubst(strcat(lasterror(), " "), """", "''"), "\", "/"));
        end
        line = mgetl(%io(1), 1);
    end
endfunction
