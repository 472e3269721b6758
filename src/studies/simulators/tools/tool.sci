// What drivers in Scilab share: tool() answers all scenes of the standard input
// by [impacts, last] = simulate(scene, level), with a row [time s, wall 1 or 2, speed m/s] for each
// impact, the last [m, m/s], and level 1 (loose), 2 or 3 (tight). A missing upper wall is at %inf.

// The force [N] at time t [s] in the scene's segment m.k.
function f = force(m, t)  // N
    u = (t - m.from(m.k)) .^ [0; 1; 2];
    f = sum((m.segments(m.k)(:, 1:3) * u) .* cos(m.segments(m.k)(:, 4:6) * u));
endfunction

function h = hold(m, t)  // N; at rest: what is missing to a force that moves the body
    f = force(m, t);
    h = m.friction - max([f(m.y(1) < m.upper), -f(m.y(1) > m.lower)]);
endfunction

function dy = rates(t, y, m)
    dy = [y(2); (force(m, t) - m.way * m.friction) / m.mass] * m.moves;
endfunction

function v = values(t, y, m)
    v = [y(1) - m.lower; min(m.upper - y(1), 1); m.way * y(2) + bool2s(m.friction == 0)];
    if ~m.moves then v = [hold(m, t); 1; 1]; end
endfunction

function m = settle(m, t, released)  // whether it moves, and in which direction
    m.moves = bool2s(released | m.y(2) <> 0 | hold(m, t) < 0);
    m.way = sign(m.y(2) + bool2s(m.y(2) == 0) * force(m, t));
endfunction

function tool()
    words = sciargs();
    level = find(words($) == ["loose", "usual", "tight"]);
    line = mgetl(%io(1), 1);
    while line <> [] & line <> ""
        scene = fromJSON(line);
        if scene.upper == "null" then scene.upper = %inf; end
        scene.from = []; scene.segments = list();  // a row [amplitude, phase] a term
        for k = 1:size(scene.force, "*")
            terms = [];
            part = scene.force(k).terms;
            for j = 1:size(part, "*"), terms(j, 1:6) = [part(j).amplitude, part(j).phase]; end
            scene.from(k) = scene.force(k).from;
            scene.segments(k) = terms;
        end
        try
            timer();
            [impacts, last] = simulate(scene, level);
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
